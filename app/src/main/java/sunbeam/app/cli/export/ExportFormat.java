package sunbeam.app.cli.export;

import java.util.Locale;
import sunbeam.precompute.setting.Choices;

enum ExportFormat {
    NPZ("100MB", 0.02),
    BSDF("100MB", 0.05),
    HTML("1MB", 0.05),
    GLSL("50MB", 0.05),
    OSL("50MB", 0.05);

    private final String size;
    private final double tolerance;

    ExportFormat(String size, double tolerance) {
        this.size = size;
        this.tolerance = tolerance;
    }

    String size() {
        return size;
    }

    double tolerance() {
        return tolerance;
    }

    /** True if the format has a divisor of radiance by direction of light. */
    boolean dividesByLight() {
        return this == NPZ || this == BSDF;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    TableWriter writer(ArrayOptions arrays, Choices asked, double tolerance) {
        if (!dividesByLight()) {
            arrays.refuse(toString());
        }
        return switch (this) {
            case NPZ -> new NpzTable(arrays.channels(asked));
            case BSDF -> arrays.bsdfTable(asked);
            case HTML -> new HtmlTable(tolerance);
            case GLSL -> new FolderTable(FolderTable.Language.GLSL);
            case OSL -> new FolderTable(FolderTable.Language.OSL);
        };
    }
}
