package sunbeam.precompute.patch;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/**
 * Turns an image's samples into metres.
 *
 * @param width extent along x of all columns together
 * @param extent extent along y of all rows together; without it pixels are square
 * @param maxHeight height of full scale: of the sample 255 of 8 bits, 65535 of 16 bits, 1.0 of float
 * @param chosen the setting that the height of full scale was chosen by
 */
record PatchScale(double width, Optional<Double> extent, double maxHeight, Setting<?> chosen) {
    private static final double ODD_ASPECT = 50;

    PatchScale(double width, Optional<Double> extent, double maxHeight) {
        this(width, extent, maxHeight, PatchSettings.MAX_HEIGHT);
    }

    /**
     * The scale that was chosen for an image.
     *
     * @param what the image, for the message
     * @throws SettingException when width or height of full scale was not chosen
     */
    static PatchScale of(Choices choices, String what) {
        Optional<Double> width = choices.find(PatchSettings.WIDTH);
        if (choices.has(PatchSettings.MAX_HEIGHT) && choices.has(PatchSettings.HEIGHT_UNIT)) {
            throw new SettingException(
                    PatchSettings.HEIGHT_UNIT, "contradicts ", PatchSettings.MAX_HEIGHT, "; give one of them");
        }
        Optional<Double> maxHeight = choices.find(PatchSettings.MAX_HEIGHT)
                .or(() -> choices.find(PatchSettings.HEIGHT_UNIT).map(HeightUnit::metres));
        if (width.isEmpty() && maxHeight.isEmpty()) {
            throw new SettingException(
                    PatchSettings.WIDTH,
                    "is missing: " + what + " is an image without scale; add for example ",
                    PatchSettings.WIDTH,
                    " 65um and ",
                    PatchSettings.MAX_HEIGHT,
                    " 375nm, or name a descriptor (.json)");
        }
        if (width.isEmpty() || maxHeight.isEmpty()) {
            var missing = width.isEmpty() ? PatchSettings.WIDTH : PatchSettings.MAX_HEIGHT;
            throw new SettingException(
                    missing,
                    "is missing: " + what + " is an image without scale; add for example ",
                    missing,
                    width.isEmpty() ? " 65um" : " 375nm",
                    ", or name a descriptor (.json)");
        }
        return new PatchScale(
                width.get(),
                choices.find(PatchSettings.HEIGHT),
                maxHeight.get(),
                choices.has(PatchSettings.HEIGHT_UNIT) ? PatchSettings.HEIGHT_UNIT : PatchSettings.MAX_HEIGHT);
    }

    /**
     * The heights of an image in metres.
     *
     * @param image its samples are overwritten
     * @throws SettingException when the scale is absurd for this image, about the quantity at fault
     */
    HeightMap apply(HeightImage image) {
        double pitchX = width / image.columns();
        double pitchY = extent.isPresent() ? extent.get() / image.rows() : pitchX;
        double longSide = Math.max(width, pitchY * image.rows());
        requirePossible(image.format(), longSide, pitchY * image.rows());
        requireFloatsForUnits(image.format());
        double metresPerUnit = maxHeight / image.format().fullScale();
        double[] heights = image.samples();
        for (int i = 0; i < heights.length; i++) {
            heights[i] *= metresPerUnit;
        }
        HeightMap map = HeightMap.owning(image.columns(), image.rows(), pitchX, pitchY, heights);
        Optional<String> absurdity = ReliefCheck.absurdity(map);
        if (absurdity.isPresent()) {
            throw new SettingException(chosen, complaint(absurdity.get(), map, metresPerUnit));
        }
        return map;
    }

    private void requirePossible(SampleFormat format, double longSide, double sideY) {
        if (longSide < ReliefCheck.SHORTEST_LONG_SIDE) {
            throw new SettingException(
                    PatchSettings.WIDTH,
                    String.format(
                            Locale.ROOT,
                            "is absurd for a patch, whose longer side is %s or more (is the unit right?)",
                            Lengths.format(ReliefCheck.SHORTEST_LONG_SIDE)));
        }
        if (sideY > ReliefCheck.LONGEST_SIDE) {
            throw new SettingException(
                    PatchSettings.WIDTH,
                    String.format(
                            Locale.ROOT,
                            "makes the patch %s long; the most is %s",
                            Lengths.format(sideY),
                            Lengths.format(ReliefCheck.LONGEST_SIDE)));
        }
        // Float images may hold plain metres (a full scale of 1 m): only their relief can be judged.
        if (format.integer() && maxHeight > ReliefCheck.LARGEST_RELIEF) {
            throw new SettingException(
                    PatchSettings.MAX_HEIGHT,
                    String.format(
                            Locale.ROOT,
                            "is absurd for the full scale of whole numbers; the most is %s (is the unit right?)",
                            Lengths.format(ReliefCheck.LARGEST_RELIEF)));
        }
    }

    private void requireFloatsForUnits(SampleFormat format) {
        if (format.integer() && chosen.equals(PatchSettings.HEIGHT_UNIT)) {
            throw new SettingException(
                    PatchSettings.HEIGHT_UNIT,
                    "is for images of floats; of whole numbers give the height of full scale with ",
                    PatchSettings.MAX_HEIGHT);
        }
    }

    /** Why the relief is absurd; floats that hold metres already are the usual cause. */
    private static Object[] complaint(String absurdity, HeightMap map, double metresPerUnit) {
        String complaint = "makes a relief of " + absurdity;
        double samples = map.relief() / metresPerUnit;
        boolean metres = map.relief() < ReliefCheck.SMALLEST_RELIEF
                && samples > ReliefCheck.SMALLEST_RELIEF
                && samples < ReliefCheck.LARGEST_RELIEF;
        return metres
                ? new Object[] {
                    complaint + "; the samples reach over " + Lengths.format(samples) + " if they are metres: give ",
                    PatchSettings.HEIGHT_UNIT,
                    " m instead"
                }
                : new Object[] {complaint};
    }

    /**
     * What is possible but unlikely about heights in this scale.
     *
     * @param origin where the height of full scale was chosen
     */
    List<String> warnings(HeightMap map, SampleFormat format, Origin origin) {
        List<String> warnings = new ArrayList<>();
        double longSide = Math.max(map.width(), map.height());
        if (map.relief() > longSide) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "the relief of %s is larger than the patch (%s); is %s right?",
                    Lengths.format(map.relief()),
                    Lengths.format(longSide),
                    origin.name(chosen)));
        }
        warnings.addAll(oddities(map));
        if (format.integer()) {
            SamplingCheck.heightStep(maxHeight / format.fullScale()).ifPresent(warnings::add);
        }
        return warnings;
    }

    /** What is possible but unlikely about the sides of a map. */
    static List<String> oddities(HeightMap map) {
        List<String> warnings = new ArrayList<>();
        double aspect = Math.max(map.pitchX() / map.pitchY(), map.pitchY() / map.pitchX());
        if (map.columns() > 1 && map.rows() > 1 && aspect > ODD_ASPECT) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "samples are %s apart along x and %s along y; is the height, the extent along y, right?",
                    Lengths.format(map.pitchX()),
                    Lengths.format(map.pitchY())));
        }
        return warnings;
    }
}
