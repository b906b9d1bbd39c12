package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CROP;
import static sunbeam.precompute.patch.PatchSettings.DESPIKE;
import static sunbeam.precompute.patch.PatchSettings.EDGES;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.PERIODIC;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.fault.ScanFaults;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.prepare.OnePeriod;
import sunbeam.precompute.prepare.Preparation;
import sunbeam.precompute.prepare.Seam;
import sunbeam.precompute.prepare.Spikes;
import sunbeam.precompute.prepare.Tilt;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/**
 * From heights in metres to a patch: what holds where nothing was chosen, the preparing, and what the user should know.
 *
 * @param name of the patch
 * @param file for messages
 * @param choices of {@link PatchSettings#PREPARING}
 * @param kind where the heights come from
 */
record PatchAssembler(String name, String file, Choices choices, Kind kind) {
    // Of the heights' variance, in their plane: less is no tilt that anybody sees.
    private static final double TILTED = 0.1;
    // How many times larger the step at the border is than between neighbors, before its streaks are seen.
    private static final double TORN = 4;

    /** Where heights come from. */
    enum Kind {
        /** Periodic by construction. */
        BUILT_IN,
        /** A descriptor: repeated as it is, and lines that were drawn are a period. */
        DESCRIBED,
        /** A file that somebody names: a piece of a surface. */
        GIVEN_DIRECTLY
    }

    /**
     * The patch.
     *
     * @throws PatchException when no sample is there
     * @throws SettingException when a choice does not suit the heights
     */
    Patch patch(MeasuredHeights read) {
        HeightMap measured = read.map();
        Patch.Repetition repetition = repetition(measured);
        boolean piece = repetition == Patch.Repetition.NONE && kind == Kind.GIVEN_DIRECTLY;
        Levelling levelling = choices.get(LEVEL, piece ? Levelling.PLANE : Levelling.MEAN);
        Edges edges = choices.get(EDGES, piece ? Edges.BLEND : Edges.REPEAT);
        Preparation preparation = new Preparation(choices.find(CROP), levelling, choices.get(DESPIKE, false), edges);
        Preparation.Prepared prepared = prepared(preparation, measured);
        HeightMap scan = prepared.scan();
        HeightMap heights = edges == Edges.REPEAT ? scan : prepared.surface();
        boolean periodic = repetition == Patch.Repetition.PERIODIC;
        List<PatchFault> faults = periodic ? List.of() : faults(measured, levelling);
        List<String> warnings = new ArrayList<>();
        if (kind != Kind.BUILT_IN) {
            warnings.addAll(Plausibility.oddities(measured));
        }
        faults.forEach(fault -> warnings.add(fault.line()));
        if (prepared.missing() > 0) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%d of %d samples are missing and were filled from their neighbors",
                    prepared.missing(),
                    (long) scan.columns() * scan.rows()));
        }
        if (kind != Kind.BUILT_IN && !preparation.despike()) {
            Spikes.conspicuous(prepared.scan()).map(this::spikes).ifPresent(warnings::add);
        }
        repetitionWarning(measured, prepared, levelling, edges, repetition).ifPresent(warnings::add);
        Plausibility.mirror(heights).ifPresent(warnings::add);
        SamplingCheck.pitch(heights).ifPresent(warnings::add);
        // Of what was measured, as inspect tells it: blending bends the border.
        SlopeCheck.slopes(scan).ifPresent(warnings::add);
        return new Patch(
                name,
                heights,
                scan,
                read.source() + ", " + String.join(", ", prepared.steps()),
                read.channels(),
                read.notes(),
                warnings,
                faults,
                choices.find(CROP).map(crop -> crop.samples(measured).area(measured)),
                repetition);
    }

    private Patch.Repetition repetition(HeightMap measured) {
        if (choices.has(PERIODIC)) {
            return choices.get(PERIODIC, false) ? Patch.Repetition.PERIODIC : Patch.Repetition.NONE;
        }
        if (choices.has(CROP) || (choices.has(EDGES) && kind != Kind.BUILT_IN) || kind == Kind.GIVEN_DIRECTLY) {
            return Patch.Repetition.NONE;
        }
        boolean period = kind == Kind.BUILT_IN || OnePeriod.isDrawn(measured);
        return period ? Patch.Repetition.PERIODIC : Patch.Repetition.ASSUMED;
    }

    private Preparation.Prepared prepared(Preparation preparation, HeightMap measured) {
        try {
            preparation.cropped(measured);
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(CROP, wrong.getMessage());
        }
        try {
            return preparation.apply(measured);
        } catch (IllegalArgumentException nothing) {
            throw new PatchException(
                    file + ": " + nothing.getMessage() + " (NaN, infinite or transparent); export the scan again",
                    nothing);
        }
    }

    /** Those that stay, with what leaves them out or takes them away. */
    private List<PatchFault> faults(HeightMap measured, Levelling levelling) {
        boolean levelled = levelling == Levelling.ROWS || levelling == Levelling.MEDIAN_ROWS;
        return ScanFaults.in(measured, choices.find(CROP)).stream()
                .filter(fault -> !levelled || fault.levelling().isEmpty())
                .map(fault -> new PatchFault(fault.words(), remedy(fault, measured), fault.unmeasured()))
                .toList();
    }

    private String remedy(ScanFault fault, HeightMap measured) {
        return fault.part()
                .map(part -> named(CROP, part.written(measured.pitchX(), measured.pitchY())) + " leaves them out")
                .or(() -> fault.levelling().map(by -> named(LEVEL, by.label()) + " takes that away"))
                .orElse("");
    }

    private String spikes(Spikes spikes) {
        return String.format(
                Locale.ROOT,
                "%d samples stand alone, up to %s off all around them, as dust does, and make most of the relief; remove them (%s)",
                spikes.count(),
                Lengths.rounded(spikes.largest(), 3),
                choices.origin(PatchSettings.PATCH).name(DESPIKE));
    }

    /** What is wrong with the patch as it repeats, or does not. */
    private Optional<String> repetitionWarning(
            HeightMap measured,
            Preparation.Prepared prepared,
            Levelling levelling,
            Edges edges,
            Patch.Repetition repetition) {
        HeightMap scan = prepared.scan();
        if (repetition == Patch.Repetition.NONE && levelling.takesTilt() && OnePeriod.isDrawn(measured)) {
            return Optional.of(
                    "its lines are the same all along one axis, as drawn ones are; if it is a period of a grating, say so ("
                            + choices.origin(PatchSettings.PATCH).name(PERIODIC) + ")");
        }
        boolean said = choices.get(PERIODIC, false);
        if (edges == Edges.BLEND || (repetition == Patch.Repetition.PERIODIC && !said)) {
            return Optional.empty();
        }
        Tilt tilt = levelling.takesTilt() || said ? Tilt.NONE : Tilt.of(scan);
        if (tilt.share() > TILTED) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "the scan's repetition has a step that draws a cross: it is tilted by %s from corner to corner; level it (%s)",
                    Lengths.rounded(tilt.rise(), 3),
                    named(LEVEL, Levelling.PLANE.label())));
        }
        Seam seam = Seam.of(scan);
        if (seam.ratio() <= TORN || (said && seam.fits())) {
            return Optional.empty();
        }
        return Optional.of(String.format(
                Locale.ROOT,
                "the scan's repetition has a step that draws a cross: opposite borders differ by %s rms (neighbors by"
                        + " %s); %s",
                Lengths.rounded(seam.jump(), 2),
                Lengths.rounded(seam.inside(), 2),
                said
                        ? "crop it to a period ("
                                + choices.origin(PatchSettings.PATCH).name(CROP) + ")"
                        : "blend them (" + named(EDGES, Edges.BLEND.label()) + ")"));
    }

    /** A choice as it may be written where the patch was named. */
    private String named(Setting<?> setting, String value) {
        return choices.origin(PatchSettings.PATCH).name(setting) + " " + value;
    }
}
