package sunbeam.app.files.input;

import static sunbeam.precompute.plan.MethodSettings.ILLUMINANT;
import static sunbeam.precompute.plan.MethodSettings.OBSERVER;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTHS;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.units.Decimals;

/**
 * Reader of the color matching functions times the light. An illuminant's file has columns of nanometers and power, as
 * {@link Illuminant#ofRows} takes them.
 */
public final class LightTable {
    private static final long LARGEST_BYTES = 1 << 20;
    private static final double LARGEST_GAP_NANOMETERS = 20;

    private LightTable() {}

    /** Returns the light for the observer. Throws InputException for a file, SettingException for a band without power. */
    public static CieTable of(Choices choices) {
        String light = choices.get(ILLUMINANT);
        Illuminant illuminant = MethodSettings.isLightFile(light) ? read(Path.of(light)) : Illuminant.of(light);
        try {
            return CieTable.of(choices.get(OBSERVER), illuminant, choices.get(WAVELENGTHS));
        } catch (IllegalArgumentException dark) {
            throw choices.complaint(WAVELENGTHS, "lies where " + illuminant.name() + " has no power; give another");
        }
    }

    /** Refuses the first chosen setting of the light for results that do not depend on it. */
    public static void requireNone(Choices choices, List<Setting<?>> settings) {
        for (Setting<?> setting : settings) {
            if (choices.has(setting)) {
                throw choices.complaint(
                        setting, "has no meaning for spectral power, which is the same in all light; leave it out");
            }
        }
    }

    private static Illuminant read(Path file) {
        InputException.requireSmall(file, LARGEST_BYTES, "it is larger than 1 MiB; is this a spectrum?");
        return InputException.naming(
                file, () -> illuminant(file.getFileName().toString(), powers(Files.readString(file))));
    }

    private static Illuminant illuminant(String name, NavigableMap<Double, Double> powers) {
        if (powers.isEmpty()
                || powers.firstKey() > CieTable.FIRST_NANOMETER
                || powers.lastKey() < CieTable.LAST_NANOMETER) {
            throw new InputException((powers.isEmpty()
                            ? "it has no row of wavelength and power"
                            : "its wavelengths reach from " + Decimals.format(powers.firstKey()) + " to "
                                    + Decimals.format(powers.lastKey()) + " nm")
                    + ", and 380 to 780 nm are needed, in nanometers, 0 where there is no light");
        }
        requireCloseRows(powers.subMap(
                powers.floorKey((double) CieTable.FIRST_NANOMETER),
                true,
                powers.ceilingKey((double) CieTable.LAST_NANOMETER),
                true));
        try {
            return Illuminant.ofRows(name, powers);
        } catch (IllegalArgumentException wrong) {
            throw new InputException(wrong.getMessage());
        }
    }

    private static void requireCloseRows(NavigableMap<Double, Double> powers) {
        for (double row : powers.tailMap(powers.firstKey(), false).keySet()) {
            double before = powers.lowerKey(row);
            if (row - before > LARGEST_GAP_NANOMETERS) {
                throw new InputException("between " + Decimals.format(before) + " and " + Decimals.format(row)
                        + " nm it has no row; give one every 20 nm at least");
            }
        }
    }

    private static NavigableMap<Double, Double> powers(String text) throws IOException {
        NavigableMap<Double, Double> powers = new TreeMap<>();
        try (CsvReader<CsvRecord> rows = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .fieldSeparator(separator(text))
                .ofCsvRecord(text.substring(
                        SeparatorLine.of(text).map(String::length).orElse(0)))) {
            rows.forEach(row -> enter(row, powers));
        } catch (CsvParseException broken) {
            throw new InputException("it is no table of text", broken);
        }
        return powers;
    }

    private static String separator(String text) {
        Optional<String> excel = SeparatorLine.of(text);
        if (excel.isPresent()) {
            return String.valueOf(SeparatorLine.separator(excel.get()));
        }
        String first = text.lines()
                .filter(line -> !line.isBlank() && !line.startsWith("#"))
                .findFirst()
                .orElse("");
        return first.contains("\t") ? "\t" : first.contains(";") ? ";" : ",";
    }

    private static void enter(CsvRecord row, NavigableMap<Double, Double> powers) {
        String line = ", line " + row.getStartingLineNumber();
        OptionalDouble wavelength = Decimals.parse(row.getField(0).strip());
        if (wavelength.isEmpty()) {
            if (powers.isEmpty() && row.getFieldCount() > 1) {
                return;
            }
            throw new InputException("'" + row.getField(0) + "'" + line + " is no wavelength");
        }
        OptionalDouble power =
                row.getFieldCount() == 2 ? Decimals.parse(row.getField(1).strip()) : OptionalDouble.empty();
        if (power.isEmpty() || !(power.getAsDouble() >= 0)) {
            throw new InputException("it needs two columns, wavelength and power, which is not negative" + line);
        }
        if (powers.put(wavelength.getAsDouble(), power.getAsDouble()) != null) {
            throw new InputException("it has " + Decimals.format(wavelength.getAsDouble()) + " nm twice" + line);
        }
    }
}
