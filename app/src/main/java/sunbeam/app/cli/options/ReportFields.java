package sunbeam.app.cli.options;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import sunbeam.app.measure.errors.Certificate;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.ScanFaults.ScanFault;

/** Fields that the JSON of several commands has; docs/reference/report.schema.json describes them. */
public final class ReportFields {
    private ReportFields() {}

    /** Returns verdict, period and faults of a surface: lengths in meters, angles in degrees; null for values that are unknown. */
    public static Map<String, Object> of(Patch patch, GratingPeriod period, Verdict verdict) {
        boolean sure = period.isSure();
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", patch.name());
        fields.put("source", patch.source());
        fields.put("verdict_code", verdict.code().label());
        fields.put("verdict", verdict.sentence());
        fields.put("period_m", sure ? period.period() : null);
        fields.put("period_low_m", sure ? period.low() : null);
        fields.put("period_high_m", sure ? period.high() : null);
        fields.put("period_probability", sure ? GratingPeriod.PROBABILITY : null);
        fields.put("direction_deg", sure ? Math.toDegrees(period.azimuth()) : null);
        fields.put("direction_half_width_deg", sure ? Math.toDegrees(period.azimuthHalfWidth()) : null);
        fields.put("periods_in_the_scan", sure && !period.isExact() ? period.periods() : null);
        fields.put("share_of_variance", sure ? period.share() : null);
        fields.put("period_not_told", sure ? null : period.reason());
        fields.put("about_m", period.isSeen() ? period.period() : null);
        fields.put("directions_deg", period.isSeen() ? period.directions() : List.of());
        fields.put(
                "first_orders_deg",
                verdict.firstOrders().stream()
                        .map(band -> List.of(hundredths(band.blue()), hundredths(band.red())))
                        .toList());
        fields.put("faults", patch.faults().stream().map(ScanFault::line).toList());
        fields.put("notes", patch.notes());
        fields.put("warnings", patch.warnings());
        return fields;
    }

    private static double hundredths(double degrees) {
        return Math.rint(100 * degrees) / 100;
    }

    /** Returns relative errors; their number alone if there are none. */
    public static Map<String, Object> of(ErrorStatistics errors) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("count", errors.count());
        if (errors.count() > 0) {
            fields.put("median", errors.median());
            fields.put("percentile_95", errors.percentile95());
            fields.put("maximum", errors.maximum());
        }
        return fields;
    }

    public static Map<String, Object> of(Certificate certificate) {
        Map<String, Object> fields = of(certificate.relative());
        fields.put("missed", certificate.missed());
        fields.put("summary", certificate.summary());
        return fields;
    }
}
