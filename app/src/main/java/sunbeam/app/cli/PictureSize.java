package sunbeam.app.cli;

import picocli.CommandLine.TypeConversionException;

/** Width and height of a picture in pixels, 1 to 16384 each. */
public record PictureSize(int width, int height) {
    private static final int LARGEST = 16_384;
    /** Limit of pixels: 2 GiB of linear light at 16 bytes a pixel. */
    private static final long MOST_PIXELS = 1L << 27;

    public PictureSize {
        boolean sides = width >= 1 && height >= 1 && width <= LARGEST && height <= LARGEST;
        if (!sides || (long) width * height > MOST_PIXELS) {
            throw new IllegalArgumentException(width + "x" + height + " is out of range; give sides of 1 to " + LARGEST
                    + " and at most " + (MOST_PIXELS >> 20) + " million pixels");
        }
    }

    @Override
    public String toString() {
        return width + "x" + height;
    }

    /** Parses {@code WIDTHxHEIGHT}, or the side of a square. */
    public static PictureSize parse(String text) {
        if (!text.strip().matches("\\d{1,6}([xX]\\d{1,6})?")) {
            throw new TypeConversionException(
                    "'" + text + "' is not a size; give WIDTHxHEIGHT as in 800x600, or one side of a square");
        }
        String[] sides = text.strip().split("[xX]", -1);
        try {
            return new PictureSize(Integer.parseInt(sides[0]), Integer.parseInt(sides[sides.length - 1]));
        } catch (IllegalArgumentException outOfRange) {
            throw new TypeConversionException(outOfRange.getMessage());
        }
    }
}
