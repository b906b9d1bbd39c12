package sunbeam.app.measure.accuracy;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.StringJoiner;
import jrtr.RenderContext;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.SettingException;

/**
 * Holds method {@code full} to its tolerance on surfaces at the edges of what can be asked for: a table with a row for
 * each surface, window, average and quantity, and a column for each tolerance.
 */
final class Extremes {
    private static final double[] TOLERANCES = {1e-2, 1e-3, 1e-4};
    private static final int POWERS_OF_EACH_AIM = 10;
    private static final int COLORS_OF_EACH_AIM = 2;
    // The exact colours take a sum over the patch at each of hundreds of wavelengths.
    private static final int MOST_SAMPLES_OF_COLORS = 128 * 128;
    private static final double LONGEST_IN_SAMPLES_OF_COLORS = 1300;

    private final RenderContext context;
    private final PrintWriter out;
    private int missed;
    private int said;
    private int tried;

    Extremes(RenderContext context, PrintWriter out) {
        this.context = context;
        this.out = out;
    }

    /**
     * Measures all and prints the table.
     *
     * @return how often a tolerance was missed
     */
    int run(List<Extreme> extremes) {
        out.println("| surface | coherence length | average | quantity | directions | 1e-2 | 1e-3 | 1e-4 |");
        out.println("|---|---|---|---|---|---|---|---|");
        for (Extreme extreme : extremes) {
            HeightMap map = extreme.map().get();
            for (double coherenceLength : extreme.coherenceLengths()) {
                for (Average average : Average.values()) {
                    measure(extreme.name(), map, coherenceLength, average, false);
                    if ((long) map.columns() * map.rows() <= MOST_SAMPLES_OF_COLORS
                            && coherenceLength < LONGEST_IN_SAMPLES_OF_COLORS * Math.min(map.pitchX(), map.pitchY())) {
                        measure(extreme.name(), map, coherenceLength, average, true);
                    }
                }
            }
        }
        out.printf(
                Locale.ROOT,
                "%n%d results, %d missed their tolerance, %d of them as the plan had said%n",
                tried,
                missed,
                said);
        return missed;
    }

    private void measure(String name, HeightMap map, double coherenceLength, Average average, boolean colors) {
        RandomCase all = drawn(name, map, coherenceLength, average, colors);
        double[][] exact = all.exact();
        StringJoiner cells = new StringJoiner(" | ");
        int directions = 0;
        for (double tolerance : TOLERANCES) {
            RandomCase asked = all.with(tolerance);
            try {
                RandomCase.Outcome outcome = asked.measure(context, exact);
                directions = outcome.errors().count();
                cells.add(directions == 0 ? "dark" : judged(outcome, tolerance));
            } catch (SettingException refusal) {
                cells.add("refused: " + refusal.getMessage());
            }
        }
        out.printf(
                Locale.ROOT,
                "| %s | %s um | %s | %s | %d | %s |%n",
                name,
                Math.round(coherenceLength * 1e6),
                average.toString().toLowerCase(Locale.ROOT),
                colors ? "XYZ" : "power",
                directions,
                cells);
        out.flush();
    }

    private String judged(RandomCase.Outcome outcome, double tolerance) {
        tried++;
        String measured = String.format(
                Locale.ROOT,
                "%.1e / %.1e",
                outcome.errors().median(),
                outcome.errors().percentile95());
        if (outcome.errors().meets(tolerance)) {
            return measured;
        }
        missed++;
        said += outcome.said() ? 1 : 0;
        return measured + (outcome.said() ? " **missed, as the plan says**" : " **missed**");
    }

    /** As many directions of each aim. */
    private static RandomCase drawn(
            String name, HeightMap map, double coherenceLength, Average average, boolean colors) {
        SplittableRandom random = new SplittableRandom(1);
        GaussianArea area =
                new GaussianArea(CoherenceWindow.ofCoherenceLength(coherenceLength), WindowOrigin.CENTRE, average);
        List<Query> queries = new ArrayList<>();
        for (RandomAim aim : RandomAim.values()) {
            for (int i = 0; i < (colors ? COLORS_OF_EACH_AIM : POWERS_OF_EACH_AIM); i++) {
                double wavelength = RandomAim.wavelength(random);
                queries.add(new Query(
                        aim.draw(random, map, wavelength, area.window().sigmaFrequency()), wavelength));
            }
        }
        return new RandomCase(0, name, map, area, TOLERANCES[0], "all aims", colors, queries);
    }
}
