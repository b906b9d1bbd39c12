package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CROP;
import static sunbeam.precompute.patch.PatchSettings.DESPIKE;
import static sunbeam.precompute.patch.PatchSettings.EDGES;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.PERIODIC;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.Edges.Seam;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.Preparation;
import sunbeam.precompute.prepare.Preparation.Spikes;
import sunbeam.precompute.prepare.RowWave;
import sunbeam.precompute.prepare.ScanFault;
import sunbeam.precompute.prepare.ScanFaults;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Lengths;

/** Makes a patch from heights: defaults, preparation, warnings. */
record PatchAssembler(String name, String file, Choices choices, Kind kind) {
    // Relative to the steps between neighbors; causes no visible streaks.
    private static final double LARGEST_BORDER_STEP = 4;
    // Meters: half of sunlight's coherence length. Larger patches are scans.
    private static final double LARGEST_SYNTHETIC = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / 2;
    // Relative to the relief; measured lines differ by more.
    private static final double SAME = 1e-6;

    enum Kind {
        BUILT_IN,
        /** File of a descriptor: repeated unless cropped or with edges; a true period if it looks synthetic. */
        DESCRIBED,
        GIVEN_DIRECTLY
    }

    /**
     * @throws InputException if all samples are missing
     * @throws SettingException if a choice does not fit the heights
     */
    Patch patch(MeasuredHeights read) {
        HeightMap measured = read.map();
        Patch.Repetition repetition = repetition(measured);
        boolean piece = repetition == Patch.Repetition.NONE && kind == Kind.GIVEN_DIRECTLY;
        Preparation preparation = new Preparation(
                choices.find(CROP),
                choices.get(LEVEL, piece ? Leveling.PLANE : Leveling.MEAN),
                choices.get(DESPIKE, false),
                choices.get(EDGES, piece ? Edges.BLEND : Edges.REPEAT));
        Crop.Samples samples = samples(measured);
        Preparation.Prepared prepared = prepared(preparation, measured);
        HeightMap surface = prepared.surface();
        HeightMap scan = prepared.scan();
        List<ScanFault> faults = repetition == Patch.Repetition.PERIODIC
                ? List.of()
                : faults(measured, preparation.leveling(), samples.area(measured));
        List<String> warnings = kind == Kind.BUILT_IN ? new ArrayList<>() : Plausibility.oddities(measured);
        faults.forEach(fault -> warnings.add(fault.line()));
        Patch.gaps(prepared.known()).ifPresent(warnings::add);
        removedWave(measured, preparation).ifPresent(warnings::add);
        spikes(scan, preparation).ifPresent(warnings::add);
        repetitionWarning(measured, scan, preparation, repetition).ifPresent(warnings::add);
        Plausibility.mirror(measured, scan, prepared.steps()).ifPresent(warnings::add);
        Plausibility.pitch(surface).ifPresent(warnings::add);
        // Before blending, which bends the border.
        ModelError.of(ScanFault.measured(prepared.known(), faults), ScanFault.measured(scan, faults), repetition)
                .warning()
                .ifPresent(warnings::add);
        String source = read.source() + ", " + String.join(", ", prepared.steps());
        return new Patch(
                name,
                surface,
                scan,
                prepared.known(),
                source,
                read.channels(),
                read.notes(),
                warnings,
                faults,
                repetition);
    }

    private Patch.Repetition repetition(HeightMap measured) {
        if (choices.has(PERIODIC)) {
            return choices.get(PERIODIC, false) ? Patch.Repetition.PERIODIC : Patch.Repetition.NONE;
        }
        if (choices.has(CROP) || (choices.has(EDGES) && kind != Kind.BUILT_IN) || kind == Kind.GIVEN_DIRECTLY) {
            return Patch.Repetition.NONE;
        }
        return kind == Kind.BUILT_IN || looksSynthetic(measured) ? Patch.Repetition.PERIODIC : Patch.Repetition.ASSUMED;
    }

    private Crop.Samples samples(HeightMap measured) {
        try {
            return choices.find(CROP).map(crop -> crop.samples(measured)).orElseGet(() -> Crop.Samples.allOf(measured));
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(CROP, wrong.getMessage());
        }
    }

    private Preparation.Prepared prepared(Preparation preparation, HeightMap measured) {
        try {
            return preparation.apply(measured);
        } catch (IllegalArgumentException nothing) {
            throw new InputException(
                    file + ": " + nothing.getMessage() + " (NaN, infinite or transparent); export the scan again",
                    nothing);
        }
    }

    /** Returns the faults that the leveling leaves; parts without faults are relative to the present crop. */
    private List<ScanFault> faults(HeightMap measured, Leveling leveling, Crop area) {
        boolean leveled = leveling == Leveling.ROWS || leveling == Leveling.MEDIAN_ROWS;
        return ScanFaults.in(measured, choices.find(CROP)).stream()
                .filter(fault -> !leveled || fault.leveling().isEmpty())
                .map(fault -> new ScanFault(
                        fault.words(),
                        fault.part().map(part -> part.from(area.left(), area.bottom())),
                        fault.leveling(),
                        fault.unmeasured(),
                        remedy(fault)))
                .toList();
    }

    private String remedy(ScanFault fault) {
        return fault.part()
                .map(part -> named(CROP, part.written()) + " leaves them out")
                .or(() -> fault.leveling().map(by -> named(LEVEL, ValueKind.name(by)) + " removes this"))
                .orElse("");
    }

    private Optional<String> removedWave(HeightMap measured, Preparation preparation) {
        Leveling leveling = preparation.leveling();
        if (leveling != Leveling.ROWS && leveling != Leveling.MEDIAN_ROWS) {
            return Optional.empty();
        }
        HeightMap cropped = preparation.crop().map(crop -> crop.apply(measured)).orElse(measured);
        return RowWave.period(Leveling.PLANE.apply(cropped)).stream()
                .mapToObj(period -> "levelling " + ValueKind.name(leveling) + " takes away a wave of about "
                        + Lengths.rounded(period, 2) + " across the rows; if it is a grating, keep it ("
                        + named(LEVEL, ValueKind.name(Leveling.PLANE)) + ")")
                .findFirst();
    }

    private Optional<String> spikes(HeightMap scan, Preparation preparation) {
        return kind == Kind.BUILT_IN || preparation.despike()
                ? Optional.empty()
                : Spikes.conspicuous(scan)
                        .map(spikes -> spikes.count() + " samples are spikes, up to "
                                + Lengths.rounded(spikes.largest(), 3)
                                + " from their surroundings, as dust is, and make most of the relief; remove them ("
                                + named(DESPIKE) + ")");
    }

    private Optional<String> repetitionWarning(
            HeightMap measured, HeightMap scan, Preparation preparation, Patch.Repetition repetition) {
        boolean takesTilt = preparation.leveling().takesTilt();
        if (!choices.has(PERIODIC) && repetition == Patch.Repetition.NONE && takesTilt && looksSynthetic(measured)) {
            return Optional.of(
                    "it is constant along one axis, like a generated grating; if it is one period of a grating,"
                            + " state it (" + named(PERIODIC) + ")");
        }
        Seam seam = Seam.of(scan);
        // A step at the border of a period belongs to its profile.
        if (repetition == Patch.Repetition.PERIODIC
                || preparation.edges() == Edges.BLEND
                || seam.ratio() <= LARGEST_BORDER_STEP) {
            return Optional.empty();
        }
        return Optional.of("the scan's repetition has a step that draws a cross: opposite borders differ by "
                + Lengths.rounded(seam.jump(), 2) + " rms (neighbors by " + Lengths.rounded(seam.inside(), 2) + "); "
                + (takesTilt ? "" : "level it (" + named(LEVEL, ValueKind.name(Leveling.PLANE)) + ") or ")
                + "blend them (" + named(EDGES, ValueKind.name(Edges.BLEND)) + ")");
    }

    /** The option or key by which the patch was named. */
    private String named(Setting<?> setting) {
        return choices.origin(PatchSettings.PATCH).name(setting);
    }

    private String named(Setting<?> setting, String value) {
        return named(setting) + " " + value;
    }

    /** True if the heights are constant along one axis, as a drawn period is. */
    static boolean looksSynthetic(HeightMap field) {
        return Math.max(field.width(), field.height()) <= LARGEST_SYNTHETIC
                && ((field.columns() > 1 && isSame(field, 1, 0)) || (field.rows() > 1 && isSame(field, 0, 1)));
    }

    private static boolean isSame(HeightMap field, int columnFactor, int rowFactor) {
        double most = SAME * field.relief();
        return field.relief() > 0
                && IntStream.range(0, field.heights().length).allMatch(i -> {
                    int column = i % field.columns();
                    int row = i / field.columns();
                    return Math.abs(field.at(column, row) - field.at(columnFactor * column, rowFactor * row)) <= most;
                });
    }
}
