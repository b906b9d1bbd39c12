package sunbeam.app.cli.render;

import com.drew.imaging.ImageProcessingException;
import com.drew.imaging.jpeg.JpegMetadataReader;
import com.drew.imaging.tiff.TiffMetadataReader;
import com.drew.lang.ByteArrayReader;
import com.drew.metadata.Metadata;
import com.drew.metadata.exif.ExifIFD0Directory;
import com.drew.metadata.exif.ExifReader;
import com.drew.metadata.icc.IccDirectory;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.awt.image.ColorConvertOp;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.zip.InflaterInputStream;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.render.ScenePicture;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.numerics.Floats;

/** A decoded photograph: samples as stored, and the orientation (1 to 8, as in Exif) that turns them upright; its methods do so. */
record Photograph(Raster raster, boolean hasAlpha, Colors colors, int orientation) {
    /** Reader with limits of side and pixels: twice those of the largest cameras. Larger photographs would take minutes. */
    private static final ImageFile FILES = new ImageFile("photograph", 32_768, 160_000_000, 4);
    /** Overlap of two pixels that counts as none, as a share of a pixel's area: it is due to rounding. */
    private static final double ROUNDING = 1e-9;

    /** A photograph in linear light, covered by its alpha; {@code clipped} where any channel of any of the file's pixels was at its maximum. */
    record Linear(ScenePicture picture, boolean[] clipped) {}

    /** Reads a PNG, JPEG or TIFF of 8 or 16 bits, without a profile as sRGB; refuses unknown colors. */
    static Photograph read(Path file) {
        BufferedImage decoded = FILES.read(file, Runtime.getRuntime().maxMemory());
        Tags tags = Tags.read(file);
        BufferedImage image = decoded.getColorModel() instanceof IndexColorModel palette
                ? palette.convertToIntDiscrete(decoded.getRaster(), false)
                : decoded;
        ColorModel model = image.getColorModel();
        ColorSpace space = tags.profile().<ColorSpace>map(ICC_ColorSpace::new).orElse(model.getColorSpace());
        Colors colors = Colors.of(file, image.getRaster(), model.getNumColorComponents(), space, tags.hasProfile());
        return new Photograph(image.getRaster(), model.hasAlpha(), colors, tags.orientation());
    }

    private boolean isOnItsSide() {
        return orientation > 4;
    }

    int width() {
        return isOnItsSide() ? raster.getHeight() : raster.getWidth();
    }

    int height() {
        return isOnItsSide() ? raster.getWidth() : raster.getHeight();
    }

    /** Returns the upright photograph with fewer pixels: each is the mean of the light over its area. */
    Linear reduced(int columns, int rows) {
        ScenePicture picture = ScenePicture.empty(columns, rows);
        boolean[] clipped = new boolean[columns * rows];
        int bands = raster.getNumBands();
        int[] line = new int[bands * raster.getWidth()];
        for (int row = 0; row < raster.getHeight(); row++) {
            raster.getPixels(0, row, raster.getWidth(), 1, line);
            float[] light = colors.linear(line, bands);
            for (int column = 0; column < raster.getWidth(); column++) {
                spread(line, bands * column, light, column, row, picture, clipped);
            }
        }
        float[] rgba = picture.rgba();
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double[] xyz = Srgb.xyz(rgba[pixel], rgba[pixel + 1], rgba[pixel + 2]);
            for (int c = 0; c < 3; c++) {
                rgba[pixel + c] = (float) xyz[c];
            }
        }
        return new Linear(picture, clipped);
    }

    /** Adds a pixel of the file to the at most four pixels of the reduced picture that it overlaps, by area. */
    private void spread(
            int[] samples, int at, float[] light, int column, int row, ScenePicture picture, boolean[] clipped) {
        boolean fromRight = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
        boolean fromBelow = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
        int across = fromRight ? raster.getWidth() - 1 - column : column;
        int down = fromBelow ? raster.getHeight() - 1 - row : row;
        int x = isOnItsSide() ? down : across;
        int y = isOnItsSide() ? across : down;
        double scaleX = (double) picture.width() / width();
        double scaleY = (double) picture.height() / height();
        double alpha = alpha(samples, at);
        boolean isClipped = false;
        for (int i = at; i < at + colors.channels(); i++) {
            isClipped |= samples[i] == colors.white();
        }
        for (int toY = (int) (y * scaleY); toY < picture.height() && toY < (y + 1) * scaleY; toY++) {
            for (int toX = (int) (x * scaleX); toX < picture.width() && toX < (x + 1) * scaleX; toX++) {
                double area = overlap(x * scaleX, scaleX, toX) * overlap(y * scaleY, scaleY, toY);
                float weight = (float) (area * alpha);
                int pixel = toY * picture.width() + toX;
                for (int c = 0; c < 3; c++) {
                    picture.rgba()[4 * pixel + c] += weight * light[3 * column + c];
                }
                picture.rgba()[4 * pixel + 3] += weight;
                clipped[pixel] |= isClipped && area > ROUNDING;
            }
        }
    }

    private static double overlap(double from, double length, int pixel) {
        return Math.max(0, Math.min(from + length, pixel + 1) - Math.max(from, pixel));
    }

    private double alpha(int[] samples, int at) {
        int channels = colors.channels();
        int bits = raster.getSampleModel().getSampleSize(hasAlpha ? channels : 0);
        return hasAlpha ? samples[at + channels] / (Math.scalb(1.0, bits) - 1) : 1;
    }

    /**
     * Converts samples to linear light by an ICC profile, or else by the curve of sRGB, also for gray samples.
     *
     * @param channels number of color channels; an alpha channel may follow in the samples
     * @param curve linear light of each value of a sample up to {@code white}, 0 to 1, used if there is no conversion
     * @param conversion conversion by the profile to linear sRGB of 16 bits, clipped at its gamut, as the scene is for the comparison
     */
    record Colors(Path file, int channels, int white, float[] curve, Optional<ColorConvertOp> conversion) {
        private static final int WHITE_16 = 65_535;

        /** Refuses unknown kinds of samples or color spaces, and damaged profiles, for which Java takes a standard {@code space}. */
        static Colors of(Path file, Raster raster, int channels, ColorSpace space, boolean hasProfile) {
            int type = raster.getTransferType();
            int bits = raster.getSampleModel().getSampleSize(0);
            boolean isWhole =
                    type == DataBuffer.TYPE_BYTE || type == DataBuffer.TYPE_USHORT || type == DataBuffer.TYPE_INT;
            InputException.refuseIf(
                    !isWhole || bits > Short.SIZE,
                    "photograph " + file
                            + " has samples that are not of 8 or 16 bits; export it as PNG or TIFF of 16 bits");
            // Java takes gray samples for linear light, but in files they follow the curve of sRGB.
            boolean isStandard = space.isCS_sRGB() || space == ColorSpace.getInstance(ColorSpace.CS_GRAY);
            InputException.refuseIf(
                    space.getNumComponents() != channels || !(isStandard || space instanceof ICC_ColorSpace),
                    "photograph " + file + " has " + channels + " channels of color and a profile for "
                            + space.getNumComponents() + ", or none; convert it to sRGB");
            InputException.refuseIf(
                    isStandard && hasProfile,
                    "photograph " + file
                            + " has a color profile that is damaged or does not fit its samples; convert it to sRGB");
            int white = (1 << bits) - 1;
            float[] curve = Floats.of(white + 1, sample -> Srgb.linear(255.0 * sample / white));
            if (isStandard) {
                return new Colors(file, channels, white, curve, Optional.empty());
            }
            ICC_Profile linear = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB);
            ICC_Profile[] profiles = {((ICC_ColorSpace) space).getProfile(), linear};
            return new Colors(file, channels, white, curve, Optional.of(new ColorConvertOp(profiles, null)));
        }

        /** Returns red, green and blue of linear sRGB, 0 to 1, for a row of pixels of {@code bands} samples each, those of color first. */
        float[] linear(int[] samples, int bands) {
            int columns = samples.length / bands;
            float[] light = new float[3 * columns];
            if (conversion.isEmpty()) {
                for (int i = 0; i < light.length; i++) {
                    light[i] = curve[samples[bands * (i / 3) + Math.min(i % 3, channels - 1)]];
                }
                return light;
            }
            int[] scaled = new int[channels * columns];
            for (int i = 0; i < scaled.length; i++) {
                scaled[i] = (int) ((long) samples[i / channels * bands + i % channels] * WHITE_16 / white);
            }
            try {
                WritableRaster from = row(columns, channels);
                from.setPixels(0, 0, columns, 1, scaled);
                WritableRaster to = conversion.get().filter(from, row(columns, 3));
                int[] converted = to.getPixels(0, 0, columns, 1, new int[light.length]);
                IntStream.range(0, light.length).forEach(i -> light[i] = (float) converted[i] / WHITE_16);
                return light;
            } catch (RuntimeException damaged) {
                // Java reads a profile at its first use, and a damaged one fails with exceptions of many kinds.
                throw new InputException(
                        "photograph " + file + " has a color profile that cannot be used; convert it to sRGB", damaged);
            }
        }

        private static WritableRaster row(int columns, int channels) {
            return Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, columns, 1, channels, null);
        }
    }

    /**
     * Orientation of a photograph, and color profile of a PNG: Java's decoders ignore both.
     *
     * @param orientation 1 to 8 (Exif 2.32, tag 0x0112): the corner of the stored picture at which the upright picture's top left lies
     * @param profile color profile of a PNG; empty for JPEG and TIFF, whose decoders apply it
     * @param hasProfile whether a PNG or TIFF has a profile, which the TIFF decoder silently drops if it is damaged
     */
    private record Tags(int orientation, Optional<ICC_Profile> profile, boolean hasProfile) {
        /** Largest chunk, and largest decompressed profile, that is read. */
        private static final int MOST_CHUNK_BYTES = 1 << 22;
        /** Value of PNG's chunk gAMA for sRGB: 1e5 divided by 2.2. */
        private static final int SRGB_GAMMA = 45_455;
        // Tolerance of this value, so that a gamma of 0.45 counts as sRGB, too.
        private static final int GAMMA_ROUNDING = 500;

        /** @throws InputException for damaged tags, and for a PNG whose colors are neither sRGB nor described by a profile */
        static Tags read(Path file) {
            try (ImageInputStream stream = new FileImageInputStream(file.toFile())) {
                return switch (stream.readUnsignedShort()) {
                    case 0xffd8 ->
                        withoutProfile(JpegMetadataReader.readMetadata(file.toFile(), List.of(new ExifReader())));
                    case 0x8950 -> ofPng(file, chunks(stream));
                    case 0x4949, 0x4d4d -> ofTiff(TiffMetadataReader.readMetadata(file.toFile()));
                    default -> withoutProfile(new Metadata());
                };
            } catch (InputException refused) {
                throw refused;
            } catch (IOException | ImageProcessingException | RuntimeException damaged) {
                // The parsers of Exif data and of profiles fail on damaged files with exceptions of many kinds.
                throw new InputException(
                        "photograph " + file + " has damaged Exif data or a damaged profile; export it again", damaged);
            }
        }

        private static Tags withoutProfile(Metadata metadata) {
            return new Tags(orientation(metadata), Optional.empty(), false);
        }

        private static Tags ofTiff(Metadata metadata) {
            return new Tags(
                    orientation(metadata), Optional.empty(), metadata.containsDirectoryOfType(IccDirectory.class));
        }

        private static int orientation(Metadata metadata) {
            ExifIFD0Directory directory = metadata.getFirstDirectoryOfType(ExifIFD0Directory.class);
            Integer value = directory == null ? null : directory.getInteger(ExifIFD0Directory.TAG_ORIENTATION);
            return value != null && value >= 1 && value <= 8 ? value : 1;
        }

        /** Returns the contents of a PNG's chunks by type; those above 4 MiB are left empty. */
        private static Map<String, byte[]> chunks(ImageInputStream stream) throws IOException {
            Map<String, byte[]> chunks = new HashMap<>();
            for (long at = 8; !chunks.containsKey("IEND"); ) {
                stream.seek(at);
                long length = stream.readUnsignedInt();
                byte[] type = new byte[4];
                stream.readFully(type);
                byte[] content = new byte[(int) (length > MOST_CHUNK_BYTES ? 0 : length)];
                stream.readFully(content);
                chunks.putIfAbsent(new String(type, StandardCharsets.ISO_8859_1), content);
                at += 12 + length;
            }
            return chunks;
        }

        private static Tags ofPng(Path file, Map<String, byte[]> chunks) throws IOException {
            byte[] profile = chunks.get("iCCP");
            if (chunks.containsKey("cICP")) {
                throw otherColors(file, "by chunk cICP");
            }
            if (profile == null && !chunks.containsKey("sRGB") && chunks.containsKey("gAMA")) {
                int gamma = ByteBuffer.wrap(chunks.get("gAMA")).getInt();
                if (Math.abs(gamma - SRGB_GAMMA) > GAMMA_ROUNDING) {
                    throw otherColors(file, "with gamma " + gamma / 1e5);
                }
            }
            Metadata metadata = new Metadata();
            if (chunks.containsKey("eXIf")) {
                new ExifReader().extract(new ByteArrayReader(chunks.get("eXIf")), metadata);
            }
            return profile == null
                    ? withoutProfile(metadata)
                    : new Tags(orientation(metadata), Optional.of(inflatedProfile(profile)), true);
        }

        private static InputException otherColors(Path file, String how) {
            return new InputException("photograph " + file + " has colors coded " + how
                    + "; convert it to sRGB, or embed an ICC profile");
        }

        /** @param chunk content of chunk iCCP: the profile's name, byte 0, compression method 0, deflated profile */
        private static ICC_Profile inflatedProfile(byte[] chunk) throws IOException {
            ByteArrayInputStream stream = new ByteArrayInputStream(chunk);
            int next = stream.read();
            while (next > 0) {
                next = stream.read();
            }
            stream.skip(1);
            try (InflaterInputStream inflated = new InflaterInputStream(stream)) {
                return ICC_Profile.getInstance(inflated.readNBytes(MOST_CHUNK_BYTES));
            }
        }
    }
}
