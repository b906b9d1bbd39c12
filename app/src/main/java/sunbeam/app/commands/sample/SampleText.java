package sunbeam.app.commands.sample;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.measure.errors.Certificate;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.terminal.JsonOption;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.TableMethod;

/** What a file says of its rows. */
record SampleText(
        DiffractionSetup setup,
        TableMethod method,
        ColorTablePlan plan,
        Optional<Certificate> certificate,
        SampleCommand.RowKind channels,
        long seed,
        long count,
        SampleCommand.RowPart part) {

    /**
     * As JSON.
     *
     * @param besideSums how far colors of the first rows are from sums over wavelengths
     */
    String json(ErrorStatistics besideSums) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("program", "sunbeam " + Version.number());
        fields.put("patch", setup.patch().name());
        fields.put("patch_sha256", setup.patch().digest());
        fields.put("plan", plan.summary());
        fields.put("tolerance", method.tolerance());
        fields.put("average", "ensemble: mean over all positions of the coherence window");
        fields.put("coherence_length_metres", method.area().window().coherenceLength());
        fields.put("seed", seed);
        fields.put("count", count);
        fields.put("task", part.number() + "/" + part.parts());
        fields.put("first_row", part.first(count));
        fields.put("background_share", PairDensity.BACKGROUND);
        boolean colors = channels == SampleCommand.RowKind.XYZ;
        fields.put("directions", "unit vectors to light and viewer; x tangent, y bitangent, z normal");
        if (colors) {
            fields.put(
                    "xyz",
                    "X, Y, Z of diffracted power in " + setup.cie().description()
                            + "; a flat mirror in specular direction has Y = 1");
        } else {
            fields.put("wavelength", "nm, even in 380 to 780");
            fields.put("power", "1: a flat mirror in specular direction");
            fields.put("brdf", "1/sr, without mask; keratin's reflectance");
        }
        fields.put(
                "density",
                "probability by solid angles of light and view"
                        + (colors ? ", 1/sr^2" : " and by wavelength, 1/(sr^2 nm)")
                        + ": the mean of f / density estimates the integral of f over both hemispheres"
                        + (colors ? "" : " and 380 to 780 nm"));
        if (besideSums.count() > 0) {
            fields.put("error_beside_sums_over_wavelengths", besideSums.count() + " rows: " + besideSums);
        }
        certificate.ifPresent(stated -> fields.put("error_beside_reference", stated.summary()));
        return JsonOption.text(fields);
    }
}
