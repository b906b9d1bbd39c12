package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator;

/**
 * Random directions of one patch with their exact coherent power and colour: half uniform on the hemisphere, half aimed
 * at orders. Directions that are too dark for a relative error to mean anything are left out.
 */
final class ReferenceSamples {
    // Of a grating nearly all directions are dark; a patch that is dark everywhere must come to an end.
    private static final int MOST_TRIES_PER_SAMPLE = 2000;
    private static final int BATCH = 64;

    private final ExactJournal journal;
    private final String subject;
    private final HeightMap map;
    private final CoherenceWindow window;
    private final ReferenceEvaluator evaluator;
    private final List<Power> powers;
    private final List<Color> colors;

    /** How many directions of either quantity, and the seed from which all follow. */
    public record SampleCounts(int powers, int colors, long seed) {}

    /** A direction, its wavelength, and its exact power. */
    public record Power(Query query, double power) {}

    /** A direction, whose wavelength means nothing, and the exact X, Y, Z of its power. */
    public record Color(Query query, double[] xyz) {}

    /**
     * Computes samples of a patch whose window has its maximum at the given place.
     *
     * @param journal that has the exact values of a run before this one, and gets those of this
     * @param subject all that determines the values beside the counts, for the journal
     * @param progress told how many colours are done
     */
    public ReferenceSamples(
            HeightMap map,
            CoherenceWindow window,
            WindowOrigin origin,
            CieTable cie,
            SampleCounts counts,
            ExactJournal journal,
            String subject,
            LongConsumer progress) {
        this.journal = journal;
        this.subject = String.join("|", subject, window.toString(), origin.toString(), counts.toString());
        this.map = map;
        this.window = window;
        this.evaluator = new ReferenceEvaluator(map, window, origin);
        this.powers = draw("powers", counts.powers(), counts.seed(), this::power, done -> {}).stream()
                .map(exact -> new Power(exact.query(), exact.values()[0]))
                .toList();
        ReferenceColor color = new ReferenceColor(evaluator, window, cie, Quadrature.INTEGRATED);
        this.colors =
                draw("colours", counts.colors(), counts.seed() + 1, query -> color(color, query), progress).stream()
                        .map(exact -> new Color(exact.query(), exact.values()))
                        .toList();
    }

    public ReferenceEvaluator evaluator() {
        return evaluator;
    }

    /** Directions and wavelengths with their power; fewer than asked for where the patch is too dark. */
    public List<Power> powers() {
        return powers;
    }

    /** Directions with their colour; fewer than asked for where the patch is too dark. */
    public List<Color> colors() {
        return colors;
    }

    /** What was computed of a direction that is bright enough. */
    private record Exact(Query query, double[] values) {}

    /** Nothing where it is too dark. */
    private double[] power(Query query) {
        double power = evaluator.coherent(query.pair(), query.wavelength());
        return power > RelativeError.FLOOR ? new double[] {power} : new double[0];
    }

    private static double[] color(ReferenceColor color, Query query) {
        double[] xyz = color.xyz(query.pair(), false);
        return RelativeError.largest(xyz) > RelativeError.FLOOR ? xyz : new double[0];
    }

    private List<Exact> draw(
            String what, int count, long seed, Function<Query, double[]> evaluate, LongConsumer progress) {
        DirectionSampler sampler = new DirectionSampler(map, window, seed);
        List<Exact> results =
                new ArrayList<>(bright(what + " uniform", sampler::uniform, count / 2, evaluate, progress));
        results.addAll(bright(what + " aimed", sampler::aimed, count - count / 2, evaluate, progress));
        return List.copyOf(results);
    }

    /** The first so many that are bright enough; the same whatever the number of processors. */
    private List<Exact> bright(
            String what,
            Supplier<Query> directions,
            int count,
            Function<Query, double[]> evaluate,
            LongConsumer progress) {
        List<Exact> results = new ArrayList<>();
        for (long tried = 0; results.size() < count && tried < (long) count * MOST_TRIES_PER_SAMPLE; ) {
            int batch = Math.min(BATCH, 2 * (count - results.size()));
            List<Query> queries = Stream.generate(directions).limit(batch).toList();
            List<double[]> values = journal.batch(
                    subject + "|" + what + "|" + tried,
                    () -> queries.parallelStream().map(evaluate).toList());
            int before = results.size();
            for (int i = 0; i < batch && results.size() < count; i++) {
                if (values.get(i).length > 0) {
                    results.add(new Exact(queries.get(i), values.get(i)));
                }
            }
            progress.accept(results.size() - before);
            tried += batch;
        }
        return results;
    }
}
