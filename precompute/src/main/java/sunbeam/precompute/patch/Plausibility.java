package sunbeam.precompute.patch;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Preparation.Spikes;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Refuses impossible sizes and reliefs; warns of unlikely ones and of coarse sampling. */
public final class Plausibility {
    /** Meters: spatial frequencies reach 2 / lambda, which need a pitch of lambda / 4 (sampling theorem). */
    public static final double COARSEST_PITCH = CieTable.MINIMUM_WAVELENGTH / 4;

    /** Meters. Steps q scatter the share (k w q)^2 / 12 of the light at random: 0.2 % at the shortest wavelength and w = 2. */
    private static final double COARSEST_STEP = 5e-9;

    /** Meters; a smaller patch has no diffraction orders of visible light. */
    static final double SHORTEST_LONG_SIDE = 100e-9;

    /** Meters; the apertures of large interferometers, and wafers, have 0.3. */
    static final double LONGEST_SIDE = 1;

    private static final double LARGEST_RELIEF = 1e-3;
    static final double SMALLEST_RELIEF = 1e-12;
    /** Meters; a smaller relief scatters a few ten-thousandths of the light, as a mirror. */
    static final double FLATTEST_RELIEF = 1e-9;

    /** Ratio to the longer side. */
    static final double STEEPEST_RELIEF = 4;
    /** Samples of a flat patch; more would take minutes to process. */
    static final long MOST_FLAT_SAMPLES = 1L << 22;

    // Force microscopes reach 150 um, interference microscopes a few hundred.
    private static final double USUAL_FROM = 300e-9;
    private static final double USUAL_TO = 1e-3;
    // Samples count as integers if they have this many distinct values, each RECURRING times on average.
    private static final int FEWEST_LEVELS = 16;
    private static final int RECURRING = 4;
    // Share relative to the other samples, and distance in ranges of the others, that a mark of missing samples has.
    private static final double MOST_MARKED = 0.2;
    private static final double MARK_DISTANCE = 10;

    private Plausibility() {}

    /** Refuses a patch whose longer side, in meters, is absurd, whether the file itself states it or not. */
    static void requireSides(double width, double height, Path file, boolean own) {
        double longSide = Math.max(width, height);
        if (!(longSide >= SHORTEST_LONG_SIDE && longSide <= LONGEST_SIDE)) {
            String sides = Lengths.format(width) + " x " + Lengths.format(height) + "; a patch's longer side is "
                    + Lengths.format(SHORTEST_LONG_SIDE) + " to " + Lengths.format(LONGEST_SIDE);
            InputException.refuseIf(
                    own,
                    file + " claims to be " + sides + "; if its unit is wrong, name the right width, else crop it");
            throw new SettingException(
                    PatchSettings.WIDTH, "is absurd: " + file + " would be " + sides + " (is the unit right?)");
        }
    }

    /** @param from setting that scaled the heights; empty if the file did */
    static void requireRelief(HeightMap map, Optional<Setting<?>> from, Path file) {
        double relief = map.relief();
        double longSide = Math.max(map.width(), map.height());
        InputException.refuseIf(
                relief == 0 && map.heights().length > MOST_FLAT_SAMPLES,
                file + ": all of its " + map.columns() + " x " + map.rows() + " samples are equal: it is empty; export"
                        + " the scan again (of a flat mirror 2048 x 2048 samples are enough)");
        boolean flat = relief > 0 && relief < SMALLEST_RELIEF;
        if (flat || relief > LARGEST_RELIEF || relief > STEEPEST_RELIEF * longSide) {
            String absurd = "a relief of " + Lengths.format(relief) + " on a patch of " + Lengths.format(longSide)
                    + ", which is absurd" + (flat ? ": less than a hundredth of an atom" : "");
            InputException.refuseIf(
                    from.isEmpty(), file + " has " + absurd + "; if its unit is wrong, name the right one");
            throw new SettingException(from.orElseThrow(), "makes " + absurd + "; check both units");
        }
    }

    static List<String> oddities(HeightMap map) {
        List<String> warnings = new ArrayList<>();
        double side = Math.max(map.width(), map.height());
        if (side < USUAL_FROM || side > USUAL_TO) {
            warnings.add("the scan is " + Lengths.rounded(side, 3) + " wide, and microscopes of heights scan "
                    + Lengths.format(USUAL_FROM) + " to " + Lengths.format(USUAL_TO)
                    + ": is its unit of length right?");
        }
        if (map.relief() > side) {
            warnings.add("the relief of " + Lengths.format(map.relief()) + " is larger than the patch ("
                    + Lengths.format(side) + "): is the unit of the heights right?");
        }
        coarseHeights(map).ifPresent(warnings::add);
        repeatedOutlier(map).ifPresent(warnings::add);
        return warnings;
    }

    /** Finds a lowest or highest value that recurs far from all others, as a program's mark of missing samples does. */
    private static Optional<String> repeatedOutlier(HeightMap map) {
        for (double mark : new double[] {map.minimum(), map.maximum()}) {
            long count = Arrays.stream(map.heights()).filter(h -> h == mark).count();
            DoubleSummaryStatistics others = Arrays.stream(map.heights())
                    .filter(h -> Double.isFinite(h) && h != mark)
                    .summaryStatistics();
            double range = others.getMax() - others.getMin();
            double distance = Math.max(others.getMin() - mark, mark - others.getMax());
            if (count > 1 && count < MOST_MARKED * others.getCount() && range > 0 && distance > MARK_DISTANCE * range) {
                return Optional.of(count + " samples are " + Lengths.format(mark)
                        + ", far from all others: if this stands for missing ones, write nan instead");
            }
        }
        return Optional.empty();
    }

    /** Warns of the smallest step between some heights if they seem to be integers. */
    private static Optional<String> coarseHeights(HeightMap map) {
        double[] sorted = Spikes.sorted(map.heights());
        double[] distinct = Arrays.stream(sorted).distinct().toArray();
        if (distinct.length < FEWEST_LEVELS || sorted.length < RECURRING * distinct.length) {
            return Optional.empty();
        }
        double step = IntStream.range(1, distinct.length)
                .mapToDouble(i -> distinct[i] - distinct[i - 1])
                .min()
                .orElseThrow();
        double phase = 2 * 2 * Math.PI / CieTable.MINIMUM_WAVELENGTH * step;
        return step <= COARSEST_STEP
                ? Optional.empty()
                : Optional.of("heights are coarse: one gray level is " + Lengths.format(step)
                        + ", which scatters about " + Decimals.rounded(100 * Math.min(1, phase * phase / 12), 2)
                        + " % of the light at random; use a 16-bit or float image");
    }

    /** @param prepared the map after these steps */
    static Optional<String> mirror(HeightMap map, HeightMap prepared, List<String> steps) {
        if (map.relief() == 0) {
            return Optional.of("all heights are equal: the patch is a flat mirror");
        }
        double relief = prepared.relief();
        // The phase k w h deviates by at most k w relief / 2 from its mean, at w = 2.
        double phase = 2 * Math.PI * relief / CieTable.MINIMUM_WAVELENGTH;
        String cause = map.relief() < FLATTEST_RELIEF
                ? "is the unit of the heights right?"
                : Lengths.rounded(map.relief(), 4) + " before " + String.join(", ", steps);
        String words = "the relief is only %s (%s): the patch is a mirror that diffracts %.1g %% of the light or less";
        return Optional.of(Text.format(words, Lengths.rounded(relief, 4), cause, 100 * phase * phase))
                .filter(flat -> relief < FLATTEST_RELIEF);
    }

    public static Optional<String> pitch(HeightMap map) {
        double pitchX = map.columns() > 1 ? map.pitchX() : 0;
        double pitchY = map.rows() > 1 ? map.pitchY() : 0;
        double coarsest = Math.max(pitchX, pitchY);
        // Rounding of a pitch of exactly lambda / 4 causes no warning.
        if (coarsest <= COARSEST_PITCH * (1 + 1e-9) || map.relief() == 0) {
            return Optional.empty();
        }
        return Optional.of("sampling too coarse: samples are " + Lengths.format(coarsest) + " apart along "
                + (pitchX >= pitchY ? "x" : "y") + ", but light of " + Lengths.format(CieTable.MINIMUM_WAVELENGTH)
                + " sees structure down to " + Lengths.format(COARSEST_PITCH) + ", and lines closer than "
                + Lengths.rounded(2 * coarsest, 3) + " show as lines farther apart; use a finer scan or expect wrong"
                + " colors far from the specular direction, and false periods");
    }
}
