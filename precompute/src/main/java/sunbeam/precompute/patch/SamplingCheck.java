package sunbeam.precompute.patch;

import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Checks the pitch and the height steps of a scan against the shortest rendered wavelength. */
public final class SamplingCheck {
    /** Shortest wavelength of the model, meters. */
    public static final double SHORTEST_WAVELENGTH = 380e-9;

    /** Meters: |(u, v)| reaches 2, so spatial frequencies reach 2 / lambda, which by the sampling theorem need a pitch of lambda / 4. */
    public static final double COARSEST_PITCH = SHORTEST_WAVELENGTH / 4;

    /** Meters. Steps q scatter the share (k w q)^2 / 12 of the light at random: 0.2 % for 5 nm at the shortest wavelength and w = 2. */
    public static final double COARSEST_STEP = 5e-9;

    private SamplingCheck() {}

    /** Returns a warning if the pitch exceeds {@link #COARSEST_PITCH} along an axis of several samples. */
    public static Optional<String> pitch(HeightMap map) {
        double pitchX = map.columns() > 1 ? map.pitchX() : 0;
        double pitchY = map.rows() > 1 ? map.pitchY() : 0;
        double coarsest = Math.max(pitchX, pitchY);
        // 1e-9: rounding of a pitch of exactly lambda / 4 must not cause a warning.
        if (coarsest <= COARSEST_PITCH * (1 + 1e-9)) {
            return Optional.empty();
        }
        return Optional.of("sampling too coarse: samples are " + Lengths.format(coarsest) + " apart along "
                + (pitchX >= pitchY ? "x" : "y") + ", but light of " + Lengths.format(SHORTEST_WAVELENGTH)
                + " sees structure down to " + Lengths.format(COARSEST_PITCH) + ", and lines closer than "
                + Lengths.rounded(2 * coarsest, 3) + " show as lines farther apart; use a finer scan or expect wrong"
                + " colors far from the specular direction, and false periods");
    }

    /** Returns a warning if integer samples have steps, in meters, above {@link #COARSEST_STEP}. */
    public static Optional<String> heightStep(double step) {
        if (step <= COARSEST_STEP) {
            return Optional.empty();
        }
        double phase = 2 * 2 * Math.PI / SHORTEST_WAVELENGTH * step;
        return Optional.of("heights are coarse: one gray level is " + Lengths.format(step) + ", which scatters about "
                + Decimals.rounded(100 * Math.min(1, phase * phase / 12), 2)
                + " % of the light at random; use a 16-bit or float image");
    }
}
