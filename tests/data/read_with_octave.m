% Reads our sample files with Octave alone and prints their numbers, one "row column I Q" per line.
%
% Set before: kind (ascii, csv, bracket, binary, npy, hdf5), path, columns, bits.

offset = max (1, 2 ^ (bits - 1) - 1);
switch kind
  case "ascii"
    numbers = load ("-ascii", path).';            % Two columns I Q; blank lines are skipped.
  case "csv"
    numbers = csvread (path).' - offset;
  case "bracket"
    text = fileread (path);
    text(! ismember (text, "0123456789-")) = " ";
    numbers = sscanf (text, "%f");
  case "binary"
    width = ceil (bits / 8);
    file = fopen (path, "rb");
    bytes = fread (file, [width, Inf], "uint8");
    fclose (file);
    numbers = (256 .^ (0 : width - 1)) * bytes - offset;
  case "npy"
    file = fopen (path, "rb");
    start = fread (file, 10, "uint8");
    fseek (file, 10 + start(9) + 256 * start(10), "bof");
    numbers = fread (file, Inf, "single", 0, "ieee-le");
    fclose (file);
  case "hdf5"
    % Octave's own reader knows complex numbers in HDF5 only under other member names than r and i and gives zeros;
    % h5dump turns the dataset into plain bytes. The axes are read directly.
    data = load ("-hdf5", path);
    assert (numel (data.slant_range_m), columns);
    raw = [path ".raw"];
    assert (system (sprintf ("h5dump -d /samples -b FILE -o '%s' '%s' > /dev/null", raw, path)), 0);
    file = fopen (raw, "rb");
    numbers = fread (file, Inf, "single", 0, "ieee-le");
    fclose (file);
end

samples = reshape (numbers, 2, columns, []);
for row = 1 : size (samples, 3)
  for column = 1 : columns
    printf ("%d %d %.17g %.17g\n", row - 1, column - 1, samples(1, column, row), samples(2, column, row));
  end
end
