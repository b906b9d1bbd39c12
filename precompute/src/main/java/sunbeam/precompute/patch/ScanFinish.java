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
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.HeightField;
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
record ScanFinish(String name, String file, Choices choices, Kind kind) {
    // Of the heights' variance, in their plane: less is no tilt that anybody sees.
    private static final double TILTED = 0.1;
    // How many times larger the step at the border is than between neighbours, before its streaks are seen.
    private static final double TORN = 4;

    /** Where heights come from. */
    enum Kind {
        /** Periodic by construction. */
        BUILT_IN,
        /** A descriptor, which keeps what it has always meant where it says nothing. */
        DESCRIBED,
        /** A file that somebody names, mostly a scan as an instrument wrote it. */
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
        HeightMap scan = HeightMap.of(prepared.scan());
        HeightMap heights = edges == Edges.REPEAT ? scan : HeightMap.of(prepared.surface());
        List<String> warnings = new ArrayList<>(read.warnings());
        if (kind != Kind.BUILT_IN) {
            SizeCheck.size(measured).ifPresent(warnings::add);
        }
        FaultLines faults = faults(measured, repetition, levelling);
        faults.together().ifPresent(warnings::add);
        if (prepared.missing() > 0) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%d of %d samples are missing and were filled from their neighbours",
                    prepared.missing(),
                    (long) scan.columns() * scan.rows()));
        }
        if (kind != Kind.BUILT_IN && !preparation.despike()) {
            warnOfSpikes(prepared.scan(), warnings);
        }
        Optional<String> mirror = ReliefCheck.mirror(heights);
        mirror.ifPresent(warnings::add);
        if (measured.relief() > 0 && repetition != Patch.Repetition.PERIODIC) {
            warnOfRamp(measured, levelling, warnings);
        }
        if (mirror.isEmpty() && repetition != Patch.Repetition.PERIODIC) {
            warnOfSeam(prepared.scan(), levelling, edges, warnings);
        }
        if (choices.get(PERIODIC, false)) {
            warnOfTornPeriod(prepared.scan(), warnings);
        }
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
                faults.each(),
                choices.find(CROP).map(crop -> crop.samples(measured.field()).area(measured.field())),
                repetition);
    }

    /** A period of a surface was computed, not measured. */
    private FaultLines faults(HeightMap measured, Patch.Repetition repetition, Levelling levelling) {
        return repetition == Patch.Repetition.PERIODIC
                ? FaultLines.NONE
                : FaultLines.of(measured.field(), choices, levelling);
    }

    private Patch.Repetition repetition(HeightMap measured) {
        if (choices.has(PERIODIC)) {
            return choices.get(PERIODIC, false) ? Patch.Repetition.PERIODIC : Patch.Repetition.NONE;
        }
        if (kind == Kind.BUILT_IN && !choices.has(CROP)) {
            return Patch.Repetition.PERIODIC;
        }
        boolean described = kind == Kind.DESCRIBED;
        if (!choices.has(CROP) && !choices.has(EDGES)) {
            // Who describes a wave or a ramp means a grating; in what an instrument wrote it is waviness, a step or a
            // tilt.
            HeightField field = measured.field();
            boolean one = described ? OnePeriod.is(field) || OnePeriod.isRamp(field) : OnePeriod.isDrawn(field);
            if (one) {
                return Patch.Repetition.PERIODIC;
            }
            return described ? Patch.Repetition.ASSUMED : Patch.Repetition.NONE;
        }
        return Patch.Repetition.NONE;
    }

    private Preparation.Prepared prepared(Preparation preparation, HeightMap measured) {
        try {
            preparation.cropped(measured.field());
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(CROP, wrong.getMessage());
        }
        try {
            return preparation.apply(measured.field());
        } catch (IllegalArgumentException nothing) {
            throw new PatchException(
                    file + ": " + nothing.getMessage() + " (NaN, infinite or transparent); export the scan again",
                    nothing);
        }
    }

    /** A choice as it may be written where the patch was named. */
    private String named(Setting<?> setting, String value) {
        return choices.origin(PatchSettings.PATCH).name(setting) + " " + value;
    }

    private void warnOfSpikes(HeightField scan, List<String> warnings) {
        Spikes.conspicuous(scan)
                .ifPresent(spikes -> warnings.add(String.format(
                        Locale.ROOT,
                        "%d samples stand alone, up to %s off all around them, as dust or a slipping tip does, and make most of the"
                                + " relief; remove them (%s)",
                        spikes.count(),
                        Lengths.rounded(spikes.largest(), 3),
                        choices.origin(PatchSettings.PATCH).name(DESPIKE))));
    }

    private void warnOfRamp(HeightMap measured, Levelling levelling, List<String> warnings) {
        boolean levelled = levelling != Levelling.NONE && levelling != Levelling.MEAN;
        if (levelled && OnePeriod.isRamp(measured.field())) {
            warnings.add(
                    "the heights are one even ramp, of which levelling leaves nothing; if it is one period of a blazed"
                            + " grating, say so ("
                            + choices.origin(PatchSettings.PATCH).name(PERIODIC) + ")");
        }
    }

    /** Who asks for sharper orders than a scan can tell is told what they are. */
    private static void warnOfTornPeriod(HeightField scan, List<String> warnings) {
        Seam seam = Seam.of(scan);
        if (seam.ratio() > TORN && !seam.fits()) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "it is taken for one period, as said, but does not go on across its borders, which differ by %s rms (neighbours by %s):"
                            + " the sharp orders that are drawn are its repetition's, not the surface's",
                    Lengths.rounded(seam.jump(), 2),
                    Lengths.rounded(seam.inside(), 2)));
        }
    }

    private void warnOfSeam(HeightField scan, Levelling levelling, Edges edges, List<String> warnings) {
        List<String> faults = new ArrayList<>();
        List<String> remedies = new ArrayList<>();
        boolean tiltStays = levelling == Levelling.NONE || levelling == Levelling.MEAN;
        Tilt tilt = tiltStays ? Tilt.of(scan) : Tilt.NONE;
        if (tilt.share() > TILTED) {
            faults.add(String.format(
                    Locale.ROOT,
                    "it is tilted by %s from corner to corner (%.0f %% of the heights' variance)",
                    Lengths.rounded(tilt.rise(), 3),
                    100 * tilt.share()));
            remedies.add("level it by its plane (" + named(LEVEL, Levelling.PLANE.label()) + ")");
        }
        Seam seam = edges == Edges.REPEAT ? Seam.of(scan) : Seam.NONE;
        if (seam.ratio() > TORN) {
            faults.add(String.format(
                    Locale.ROOT,
                    "opposite borders differ by %s rms (neighbours by %s)",
                    Lengths.rounded(seam.jump(), 2),
                    Lengths.rounded(seam.inside(), 2)));
            remedies.add("blend its edges (" + named(EDGES, Edges.BLEND.label()) + ")");
        }
        if (!faults.isEmpty()) {
            warnings.add("the scan's repetition has a step that draws a cross: " + String.join(", and ", faults) + "; "
                    + String.join(" and ", remedies));
        }
    }
}
