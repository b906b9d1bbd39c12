package sunbeam.precompute.table;

import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;

/** What a table file says about itself, by attribute name; numbers in SI units. */
final class TableAttributes {
    static final String FORMAT = "sunbeam fourier table";
    static final int VERSION = 1;
    static final String CHECKSUM = "checksum_sha256";

    private final Map<String, Object> values;

    private TableAttributes(Map<String, Object> values) {
        this.values = new TreeMap<>(values);
        // The HDF5 library signs its files with an attribute of its own.
        this.values.keySet().removeIf(name -> name.startsWith("_"));
    }

    static TableAttributes of(Map<String, Object> values) {
        return new TableAttributes(values);
    }

    static TableAttributes describing(FourierTable table) {
        Map<String, Object> values = new TreeMap<>();
        values.put("format", FORMAT);
        values.put("format_version", VERSION);
        values.put("content", "terms[n][0] + i terms[n][1]: inverse DFT (1/N, exp(+i)) of T_n(h) of one period");
        values.put("rows_are", "bins of y, ascending from first_bin_y; frequency = bin / height, cycles per metre");
        values.put("columns_are", "bins of x, ascending from first_bin_x; frequency = bin / width, cycles per metre");
        values.put(
                "window", "none: the Gaussian window acts when the table is used; phases refer to the top left sample");
        values.put("patch_name", table.patch().name());
        values.put("patch_digest_sha256", table.patch().digest());
        values.put("patch_columns", table.patch().columns());
        values.put("patch_rows", table.patch().rows());
        values.put("pitch_x_metres", table.patch().pitchX());
        values.put("pitch_y_metres", table.patch().pitchY());
        values.put("expansion", table.kind().label());
        values.put("height_centre_metres", table.scale().centre());
        values.put("height_half_range_metres", table.scale().halfRange());
        values.put("first_bin_x", table.bandX().first());
        values.put("first_bin_y", table.bandY().first());
        table.coefficients().ifPresent(coefficients -> {
            values.put("coefficients_first_phase_radians", coefficients.minimumPhase());
            values.put("coefficients_last_phase_radians", coefficients.maximumPhase());
        });
        return new TableAttributes(values);
    }

    Map<String, Object> values() {
        return values;
    }

    /** Every attribute but the checksum, in one order, numbers to the last bit: what the checksum covers. */
    String canonical() {
        StringBuilder text = new StringBuilder();
        values.forEach((name, value) -> {
            if (!name.equals(CHECKSUM)) {
                String exact = value instanceof Double number ? Double.toHexString(number) : String.valueOf(value);
                text.append(name).append('=').append(exact).append('\n');
            }
        });
        return text.toString();
    }

    PatchIdentity patch() {
        return new PatchIdentity(
                text("patch_name"),
                integer("patch_columns"),
                integer("patch_rows"),
                real("pitch_x_metres"),
                real("pitch_y_metres"),
                text("patch_digest_sha256"));
    }

    ExpansionKind kind() {
        String label = text("expansion");
        for (ExpansionKind kind : ExpansionKind.values()) {
            if (kind.label().equals(label)) {
                return kind;
            }
        }
        throw new TableException("unknown expansion '" + label + "'");
    }

    HeightScale scale() {
        return new HeightScale(real("height_centre_metres"), real("height_half_range_metres"));
    }

    boolean has(String name) {
        return values.containsKey(name);
    }

    String text(String name) {
        return value(name, String.class);
    }

    int integer(String name) {
        return value(name, Integer.class);
    }

    double real(String name) {
        return value(name, Double.class);
    }

    private <T> T value(String name, Class<T> type) {
        Object value = values.get(name);
        if (!type.isInstance(value)) {
            throw new TableException("attribute '" + name + "' is missing or of the wrong type");
        }
        return type.cast(value);
    }
}
