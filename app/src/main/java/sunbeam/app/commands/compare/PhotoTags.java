package sunbeam.app.commands.compare;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_ColorSpace;
import java.awt.color.ICC_Profile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.InflaterInputStream;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.app.files.input.InputException;

/**
 * What a photograph's file says beside its pixels and Java's decoders leave out.
 *
 * @param orientation 1 to 8 (Exif 2.32, tag 0x0112): where the scene's top left lies in the file's rows; 1 where none is told
 * @param profile of colors, of a PNG; decoders honor those of JPEG and TIFF
 */
record PhotoTags(int orientation, Optional<ColorSpace> profile) {
    private static final int ORIENTATION = 0x0112;
    private static final int SHORT = 3;
    private static final int ENTRY_BYTES = 12;
    private static final int MOST_PROFILE_BYTES = 1 << 22;
    /** 1e5 over the exponent of the curve that sRGB is near to, in PNG's chunk gAMA. */
    private static final int SRGB_GAMMA = 45_455;

    private static final int GAMMA_ROUNDING = 500;

    /**
     * Reads those of PNG, JPEG and TIFF.
     *
     * @throws InputException for damaged ones, and for a PNG whose colors are coded in another way than by a profile or as sRGB
     */
    static PhotoTags read(Path file) {
        try (ImageInputStream stream = new FileImageInputStream(file.toFile())) {
            int signature = stream.readUnsignedShort();
            return switch (signature) {
                case 0xffd8 -> new PhotoTags(ofJpeg(stream), Optional.empty());
                case 0x8950 -> ofPng(file, stream);
                case 0x4949, 0x4d4d -> new PhotoTags(ofDirectory(stream, 0, stream.length()), Optional.empty());
                default -> new PhotoTags(1, Optional.empty());
            };
        } catch (IOException | IllegalArgumentException damaged) {
            throw new InputException(
                    "photograph " + file + " has damaged Exif data or a damaged profile (" + damaged.getMessage()
                            + "); export it again",
                    damaged);
        }
    }

    /** Of the first Exif segment before the picture. */
    private static int ofJpeg(ImageInputStream stream) throws IOException {
        long at = 2;
        while (true) {
            stream.seek(at);
            int marker = stream.readUnsignedShort();
            boolean isFiller = marker == 0xffff;
            boolean isPicture = marker >> 8 != 0xff || marker == 0xffda || marker == 0xffd9;
            if (isPicture) {
                return 1;
            }
            int length = isFiller ? 0 : stream.readUnsignedShort();
            long end = at + (isFiller ? 1 : 2 + length);
            if (marker == 0xffe1 && length >= 8 && text(stream, 6).equals("Exif\0\0")) {
                return ofDirectory(stream, at + 10, end);
            }
            at = end;
        }
    }

    private static PhotoTags ofPng(Path file, ImageInputStream stream) throws IOException {
        int orientation = 1;
        int gamma = SRGB_GAMMA;
        boolean isSrgb = false;
        Optional<ColorSpace> profile = Optional.empty();
        String type = "";
        for (long at = 8; !type.equals("IEND"); ) {
            stream.seek(at);
            stream.setByteOrder(ByteOrder.BIG_ENDIAN);
            long length = stream.readUnsignedInt();
            type = text(stream, 4);
            switch (type) {
                case "eXIf" -> orientation = ofDirectory(stream, at + 8, at + 8 + length);
                case "iCCP" -> profile = Optional.of(profile(stream, length));
                case "sRGB" -> isSrgb = true;
                case "gAMA" -> gamma = stream.readInt();
                case "cICP" -> throw otherColors(file, "by chunk cICP");
                default -> {}
            }
            at += 12 + length;
        }
        if (!isSrgb && profile.isEmpty() && Math.abs(gamma - SRGB_GAMMA) > GAMMA_ROUNDING) {
            throw otherColors(file, "with gamma " + gamma / 1e5);
        }
        return new PhotoTags(orientation, profile);
    }

    private static InputException otherColors(Path file, String how) {
        return new InputException(
                "photograph " + file + " has colors coded " + how + "; convert it to sRGB, or embed an ICC profile");
    }

    /** Of name, 0, method 0, deflated profile. */
    private static ColorSpace profile(ImageInputStream stream, long length) throws IOException {
        if (length > MOST_PROFILE_BYTES) {
            throw new IOException("a profile of " + length + " bytes");
        }
        byte[] data = new byte[(int) length];
        stream.readFully(data);
        int nameEnd = 0;
        while (nameEnd < data.length && data[nameEnd] != 0) {
            nameEnd++;
        }
        int from = Math.min(data.length, nameEnd + 2);
        try (InflaterInputStream inflated =
                new InflaterInputStream(new ByteArrayInputStream(data, from, data.length - from))) {
            byte[] profile = inflated.readNBytes(MOST_PROFILE_BYTES);
            return new ICC_ColorSpace(ICC_Profile.getInstance(profile));
        }
    }

    /**
     * Orientation of a TIFF directory, the first of a file or of Exif data.
     *
     * @param start of the TIFF header
     * @param end of what may be read
     */
    private static int ofDirectory(ImageInputStream stream, long start, long end) throws IOException {
        stream.seek(start);
        int order = stream.readUnsignedShort();
        stream.setByteOrder(order == 0x4949 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        int version = stream.readUnsignedShort();
        long directory = start + stream.readUnsignedInt();
        if (version != 42 || directory + 2 > end) {
            throw new IOException("no directory");
        }
        stream.seek(directory);
        int entries = stream.readUnsignedShort();
        if (directory + 2 + (long) ENTRY_BYTES * entries > end) {
            throw new IOException("a directory of " + entries + " entries");
        }
        for (int i = 0; i < entries; i++) {
            stream.seek(directory + 2 + (long) ENTRY_BYTES * i);
            int tag = stream.readUnsignedShort();
            int type = stream.readUnsignedShort();
            stream.readInt();
            int value = stream.readUnsignedShort();
            if (tag == ORIENTATION && type == SHORT) {
                return value >= 1 && value <= 8 ? value : 1;
            }
        }
        return 1;
    }

    private static String text(ImageInputStream stream, int bytes) throws IOException {
        byte[] text = new byte[bytes];
        stream.readFully(text);
        return new String(text, StandardCharsets.ISO_8859_1);
    }
}
