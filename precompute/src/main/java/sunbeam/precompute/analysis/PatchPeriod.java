package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.precompute.analysis.HeightSpectrum.RepeatedPeriod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.ScanFault;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Period of a patch: exact if the patch repeats it, else as its heights show it, taken as a piece of a surface. */
record PatchPeriod(HeightMap scan, Hypothesis asked) {
    // Meters: half of sunlight's coherence length. A larger patch may hold enough lines.
    private static final double LARGEST_REPEATED = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / 2;
    // Three periods of four samples.
    private static final int FEWEST_SAMPLES = 12;
    // Meters; three of the shortest periods with colors under light from above.
    private static final double SHORTEST_SIDE = 3 * Verdict.VIOLET;
    // Ratio of periods above which the longer one holds several lines.
    private static final double MANY_LINES = 2.5;
    private static final GratingPeriod NOTHING = GratingPeriod.vague(List.of(), 0, 0);

    static GratingPeriod of(Patch patch, Hypothesis asked) {
        PatchPeriod period = new PatchPeriod(ScanFault.bridged(patch.scan(), patch.faults()), asked);
        if (!(period.scan.relief() > 0)) {
            return NOTHING.none("flat: a mirror without color");
        }
        return switch (patch.repetition()) {
            case PERIODIC -> period.ofPeriod();
            case ASSUMED -> period.ofRepeated();
            case NONE -> period.ofPiece();
        };
    }

    /** A declared period may be so long that it holds a grating, whose lines differ slightly: a grating of split orders. */
    private GratingPeriod ofPeriod() {
        Optional<GratingPeriod> exact = RepeatedPeriod.of(scan, asked, true);
        if (exact.isEmpty()) {
            return isSmall() ? NOTHING.none(none() + " within the patch, which is taken as a period") : ofPiece();
        }
        GratingPeriod period = exact.get();
        if (period.period() <= MANY_LINES * Verdict.VIOLET) {
            return period;
        }
        GratingPeriod piece = seen();
        // Lines within a period run along its own: only a sure piece holds others, or more of a lattice's.
        boolean isParallel = period.others().isEmpty() && piece.wave().sineTo(period.wave()) < GratingPeriod.CONE;
        boolean found = piece.isSure() || (piece.isSeen() && isParallel);
        return found && period.period() > MANY_LINES * piece.period() ? piece : period;
    }

    /** A patch that a descriptor repeats is a period only if nearly all of it agrees with one, and is no longer piece of that grating. */
    private GratingPeriod ofRepeated() {
        GratingPeriod piece = ofPiece();
        Optional<GratingPeriod> exact = RepeatedPeriod.of(scan, asked, false).filter(period -> isSmall());
        boolean isPiece = piece.isSure()
                || (piece.isSeen()
                        && !exact.map(period -> period.wave().isAsLongAs(piece.wave()))
                                .orElse(false));
        return isPiece ? piece : exact.orElse(piece);
    }

    private GratingPeriod ofPiece() {
        if (Math.max(scan.columns(), scan.rows()) < FEWEST_SAMPLES) {
            return NOTHING.tooLittle(Text.format(
                    "%d x %d samples, fewer than the %d of three periods",
                    scan.columns(), scan.rows(), FEWEST_SAMPLES));
        }
        OptionalDouble step = RoundedHeights.step(scan);
        if (step.isPresent()) {
            return NOTHING.withCertainty(
                    GratingPeriod.Certainty.TOO_LITTLE,
                    Text.format(
                            "too little to judge: the heights come in steps of %s, as high as the relief; export the scan with more"
                                    + " digits",
                            Lengths.rounded(step.getAsDouble(), 2)));
        }
        GratingPeriod piece = seen();
        double side = Math.max(scan.width(), scan.height());
        return piece.isSeen() || side >= SHORTEST_SIDE
                ? piece
                : NOTHING.tooLittle(Text.format(
                        "a side of %s, less than the %s of three periods with colors from above",
                        Lengths.rounded(side, 3), Lengths.format(SHORTEST_SIDE)));
    }

    private GratingPeriod seen() {
        return PeriodModel.of(scan, asked).orElseGet(() -> NOTHING.none(none()));
    }

    private boolean isSmall() {
        return Math.max(scan.width(), scan.height()) <= LARGEST_REPEATED;
    }

    private String none() {
        return asked.nothing() + "; nothing repeats";
    }
}
