package sunbeam.app.files.input;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.TreeMap;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.units.Decimals;

/** Reader of refractive indices in the format of refractiveindex.info. */
public final class IndexFile {
    private static final long LARGEST_BYTES = 1 << 20;
    private static final double ROUNDING = 1e-6;

    private IndexFile() {}

    /** True for a file's name, not an index. */
    public static boolean isName(String text) {
        return text.strip().toLowerCase(Locale.ROOT).endsWith(".csv");
    }

    /** Reads {@code wl,n,k}, or {@code wl,n} above {@code wl,k}, wl in micrometers; InputException unless it covers 380 to 780 nm. */
    public static RefractiveIndex read(Path file) {
        InputException.requireSmall(file, LARGEST_BYTES, "it is larger than 1 MiB; is this a table of an index?");
        return InputException.naming(file, () -> parse(Files.readAllLines(file)));
    }

    private static RefractiveIndex parse(List<String> lines) {
        NavigableMap<Double, Double> real = new TreeMap<>();
        NavigableMap<Double, Double> imaginary = new TreeMap<>();
        List<String> header = List.of();
        for (int number = 1; number <= lines.size(); number++) {
            String line = lines.get(number - 1).strip();
            List<String> fields = List.of(line.split("\\s*,\\s*", -1));
            boolean isHeader = fields.get(0).equals("wl");
            header = isHeader ? fields : header;
            boolean isExcels = number == 1
                    && SeparatorLine.of(line)
                            .filter(first -> SeparatorLine.separator(first) == ',')
                            .isPresent();
            if (isHeader || isExcels || line.isEmpty()) {
                continue;
            }
            if (header.size() < 2 || fields.size() != header.size()) {
                throw unusable(number, "no header 'wl,n' or 'wl,n,k' says what it holds");
            }
            double wavelength = number(number, fields.get(0));
            for (int column = 1; column < header.size(); column++) {
                double value = number(number, fields.get(column));
                switch (header.get(column)) {
                    case "n" -> real.put(wavelength * 1e-6, value);
                    case "k" -> imaginary.put(wavelength * 1e-6, value);
                    default -> throw unusable(number, "column '" + header.get(column) + "' is neither n nor k");
                }
            }
        }
        return tabulated(real, imaginary);
    }

    private static RefractiveIndex tabulated(
            NavigableMap<Double, Double> real, NavigableMap<Double, Double> imaginary) {
        requireVisible("n", real);
        if (!imaginary.isEmpty()) {
            requireVisible("k", imaginary);
        }
        try {
            return new RefractiveIndex(real, imaginary);
        } catch (IllegalArgumentException wrong) {
            throw new InputException(wrong.getMessage(), wrong);
        }
    }

    private static void requireVisible(String column, NavigableMap<Double, Double> values) {
        InputException.refuseIf(
                values.isEmpty(),
                "it has no column " + column + "; export it from refractiveindex.info as CSV, with the header wl,n");
        double first = 1e9 * values.firstKey();
        double last = 1e9 * values.lastKey();
        if (first > CieTable.FIRST_NANOMETER + ROUNDING || last < CieTable.LAST_NANOMETER - ROUNDING) {
            throw new InputException("its " + column + " reaches from " + Math.round(first) + " to " + Math.round(last)
                    + " nm, but 380 to 780 nm are needed (wavelengths are in micrometers)");
        }
    }

    private static double number(int line, String field) {
        return Decimals.parse(field).orElseThrow(() -> unusable(line, "'" + field + "' is not a number"));
    }

    private static InputException unusable(int line, String problem) {
        return new InputException("line " + line + ": " + problem);
    }
}
