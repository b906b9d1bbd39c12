package sunbeam.precompute.patch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.units.Lengths;

/**
 * Turns an image's samples into metres. The limits are wide enough for every surface that the model can say something
 * about, and narrow enough to catch nanometres typed for micrometres.
 *
 * @param width extent along x of all columns together
 * @param extent extent along y of all rows together; without it pixels are square
 * @param maxHeight height of full scale: of the sample 255 of 8 bits, 65535 of 16 bits, 1.0 of float
 */
record PatchScale(NamedLength width, Optional<NamedLength> extent, NamedLength maxHeight) {
    /** The longer side must exceed this: no order of visible light leaves a smaller patch. */
    static final double SHORTEST_LONG_SIDE = 100e-9;
    /** One column or row alone may be this narrow. */
    static final double SHORTEST_SIDE = 1e-9;

    static final double LONGEST_SIDE = 0.1;
    static final double SMALLEST_MAX_HEIGHT = 1e-12;
    static final double LARGEST_RELIEF = 1e-3;
    /** Relief over the longer side; above, a scan is impossible and the scale is wrong. */
    static final double STEEPEST_RELIEF = 4;

    private static final double ODD_ASPECT = 50;

    /**
     * The heights of an image in metres.
     *
     * @param image its samples are overwritten
     * @throws PatchException when the scale is absurd for this image, naming the quantity at fault
     */
    HeightMap apply(HeightImage image) {
        requirePossible(image.format());
        double pitchX = width.metres() / image.columns();
        double pitchY = extent.isPresent() ? extent.get().metres() / image.rows() : pitchX;
        double longSide = Math.max(width.metres(), pitchY * image.rows());
        if (longSide < SHORTEST_LONG_SIDE) {
            width.requireBetween(SHORTEST_LONG_SIDE, LONGEST_SIDE);
        }
        if (pitchY * image.rows() > LONGEST_SIDE) {
            throw new PatchException("%s is %s, which makes the patch %s long; the most is %s"
                    .formatted(
                            width.name(),
                            Lengths.format(width.metres()),
                            Lengths.format(pitchY * image.rows()),
                            Lengths.format(LONGEST_SIDE)));
        }
        double metresPerUnit = maxHeight.metres() / image.format().fullScale();
        double[] heights = image.samples();
        for (int i = 0; i < heights.length; i++) {
            heights[i] *= metresPerUnit;
        }
        HeightMap map = HeightMap.owning(image.columns(), image.rows(), pitchX, pitchY, heights);
        requirePossibleRelief(map.relief(), longSide);
        return map;
    }

    private void requirePossible(SampleFormat format) {
        width.requireBetween(SHORTEST_SIDE, LONGEST_SIDE);
        extent.ifPresent(length -> length.requireBetween(SHORTEST_SIDE, LONGEST_SIDE));
        // Float images may hold plain metres (maxHeight 1 m): only their relief can be judged.
        double largest = format.integer() ? LARGEST_RELIEF : Double.MAX_VALUE;
        maxHeight.requireBetween(SMALLEST_MAX_HEIGHT, largest);
    }

    private void requirePossibleRelief(double relief, double longSide) {
        if (relief > LARGEST_RELIEF || relief > STEEPEST_RELIEF * longSide) {
            throw new PatchException("%s of %s makes a relief of %s on a patch of %s, which is absurd; check both units"
                    .formatted(
                            maxHeight.name(),
                            Lengths.format(maxHeight.metres()),
                            Lengths.format(relief),
                            Lengths.format(longSide)));
        }
    }

    /** What is possible but unlikely about heights in this scale. */
    List<String> warnings(HeightMap map, SampleFormat format) {
        List<String> warnings = new ArrayList<>();
        double longSide = Math.max(map.width(), map.height());
        if (map.relief() > longSide) {
            warnings.add("the relief of %s is larger than the patch (%s); is %s right?"
                    .formatted(Lengths.format(map.relief()), Lengths.format(longSide), maxHeight.name()));
        }
        double aspect = Math.max(map.pitchX() / map.pitchY(), map.pitchY() / map.pitchX());
        if (map.columns() > 1 && map.rows() > 1 && aspect > ODD_ASPECT) {
            warnings.add("samples are %s apart along x and %s along y; is the height, the extent along y, right?"
                    .formatted(Lengths.format(map.pitchX()), Lengths.format(map.pitchY())));
        }
        if (format.integer()) {
            SamplingCheck.heightStep(maxHeight.metres() / format.fullScale()).ifPresent(warnings::add);
        }
        return warnings;
    }
}
