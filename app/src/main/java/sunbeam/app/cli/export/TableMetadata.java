package sunbeam.app.cli.export;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.gpu.BrdfMapRenderer.DiscDirections;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.analysis.EnergyDivisor.EnergyBalance;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Metadata that every output states; the grid is as a reader sees it, and a divisor means that energy is conserved. */
record TableMetadata(
        DiffractionSetup setup, Choices choices, ColorGrid grid, GridErrors errors, Optional<EnergyDivisor> divisor) {
    private static final double FIRST_THETA = 30;
    /** Pixels along a side of the map whose exposure is chosen. */
    private static final int MAP_SIDE = 200;
    // Full width at half maximum of a Gaussian, in standard deviations.
    private static final double WIDTHS_PER_DEVIATION = 2 * Math.sqrt(2 * Math.log(2));

    /** Returns the full width at half maximum, in degrees, of an order at 550 nm near the normal. */
    double resolutionDegrees() {
        double sigma = GridShape.sigma(grid.level().area().window(), ColorTable.MIDDLE_WAVELENGTH);
        return Math.toDegrees(WIDTHS_PER_DEVIATION * sigma);
    }

    /** Returns the requested coherence length, meters; the table's own may be shorter. */
    double requestedCoherenceLength() {
        return choices.get(COHERENCE_LENGTH);
    }

    double coherenceLength() {
        return grid.level().area().window().coherenceLength();
    }

    String summary() {
        GridShape shape = grid.shape();
        return Text.format(
                "%s: coherence length %s (asked %s), orders %.2g degrees wide, %d x %d x %d texels of u, v, w, angles to %.4g degrees",
                setup.patch().name(),
                Lengths.rounded(coherenceLength(), 3),
                Lengths.rounded(requestedCoherenceLength(), 3),
                resolutionDegrees(),
                shape.u().count(),
                shape.v().count(),
                shape.depth().count(),
                Math.toDegrees(shape.largestAngle()));
    }

    String error() {
        String sums = "error of " + errors.quantity() + ": " + comparedWith("sums over wavelengths", errors.sums());
        return errors.reference().count() > 0 ? sums + "; " + comparedWith("the reference", errors.reference()) : sums;
    }

    private static String comparedWith(String what, ErrorStatistics errors) {
        return "beside " + what + " at " + errors.pairs() + " " + errors;
    }

    /** Returns the angle of light with which an exported page begins, degrees. */
    double theta() {
        return Math.min(FIRST_THETA, Math.toDegrees(grid.shape().largestAngle()));
    }

    /** Returns the automatic exposure that {@code brdf-map} would choose for light at {@link #theta}. */
    double exposure() {
        DiscDirections directions = new DiscDirections(MAP_SIDE, Direction.ofDegrees(theta(), 0));
        float[] xyz = new float[ColorGrid.CHANNELS * MAP_SIDE * MAP_SIDE];
        for (int pixel = 0; pixel < MAP_SIDE * MAP_SIDE; pixel++) {
            DirectionPair pair = directions.at(pixel);
            if (pair.cosThetaR() > 0) {
                double gain = Gain.relativeRadiance(pair);
                double[] power = grid.xyz(pair.u(), pair.v(), pair.w());
                for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                    xyz[ColorGrid.CHANNELS * pixel + c] = (float) (gain * power[c]);
                }
            }
        }
        return LinearPicture.exposure(new LinearPicture(MAP_SIDE, MAP_SIDE, xyz));
    }

    Map<String, Object> fields(String quantity, String interpolation) {
        Map<String, Object> fields = fields();
        fields.put("quantity", quantity);
        fields.put("interpolation", interpolation);
        return fields;
    }

    Map<String, Object> fields() {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("program", "sunbeam " + Environment.version());
        fields.put("patch", setup.patch().name());
        fields.put("patch_sha256", setup.patch().digest());
        fields.put("average", "ensemble: mean over all positions of the coherence window");
        fields.put("window", "Gaussian, standard deviation a quarter of the coherence length");
        fields.put("coherence_length_m", coherenceLength());
        fields.put("coherence_length_asked_m", requestedCoherenceLength());
        fields.put("power_scale", grid.level().scale());
        fields.put("power_scale_is", "C by power under coherence_length_m: a mean over wider orders is lower");
        fields.put("order_width_deg", resolutionDegrees());
        fields.put("illuminant", choices.get(LightSettings.ILLUMINANT));
        fields.put("wavelengths", choices.get(LightSettings.WAVELENGTHS).toString());
        fields.put("observer", choices.get(LightSettings.OBSERVER).label());
        Optional<EnergyBalance> energy =
                EnergyBalance.largest(setup.patch().scan(), RefractiveIndex.KERATIN, new Direction(0, 0, 1));
        fields.put(
                "light_sent_out_from_above_by_mirrors",
                energy.map(EnergyBalance::ratio).orElse(null));
        fields.put("light_sent_out_at_m", energy.map(EnergyBalance::wavelength).orElse(null));
        fields.put("energy", divisor.isPresent() ? "conserve: rho is divided by divisor(y, x of light)" : "scalar");
        fields.put(
                "unit",
                "1: a flat mirror in specular direction has X, Y, Z of the light with Y = 1 under the asked window");
        GridShape shape = grid.shape();
        fields.put("axes", List.of(axis("w", shape.depth(), -1), axis("v", shape.v(), 1), axis("u", shape.u(), 1)));
        fields.put(
                "directions",
                "(u, v, w) = -(wi + wr), unit vectors to light and viewer; x tangent, y bitangent, z normal");
        fields.put("largest_angle_deg", Math.toDegrees(grid.shape().largestAngle()));
        fields.put(
                "radiance",
                "rho = F(c)/F(1) K^2 / ((cos_i + cos_r)^2 cos_r) G C, c = |wi + wr| / 2, K = 2 c^2, F Schlick of 0.04, G = min(1, 2 (cos_i + cos_r) min(cos_i, cos_r) / K)");
        fields.put("error", errors.fields());
        return fields;
    }

    /** Replaces the light in the metadata of a table of bands. */
    static void putNoLight(Map<String, Object> fields) {
        fields.put("illuminant", "none: power is the same in all light");
        fields.put("observer", "none");
    }

    private static NamedAxis axis(String name, GridShape.Axis axis, int sign) {
        return new NamedAxis(name, sign * axis.first(), sign * axis.step(), axis.count());
    }

    private record NamedAxis(String name, double first, double step, int count) {}
}
