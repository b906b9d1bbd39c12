package sunbeam.app.cli.compare;

import com.drew.imaging.ImageProcessingException;
import com.drew.imaging.jpeg.JpegMetadataReader;
import com.drew.imaging.tiff.TiffMetadataReader;
import com.drew.lang.ByteArrayReader;
import com.drew.metadata.Metadata;
import com.drew.metadata.exif.ExifIFD0Directory;
import com.drew.metadata.exif.ExifReader;
import com.drew.metadata.icc.IccDirectory;
import java.awt.color.ICC_Profile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.InflaterInputStream;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.precompute.files.InputException;

/**
 * Orientation of a photograph, and color profile of a PNG: Java's decoders ignore both.
 *
 * @param orientation 1 to 8 (Exif 2.32, tag 0x0112): the corner of the stored picture at which the upright picture's top left lies
 * @param profile color profile of a PNG; empty for JPEG and TIFF, whose decoders apply it
 * @param hasProfile whether a PNG or TIFF has a profile, which the TIFF decoder silently drops if it is damaged
 */
record PhotoTags(int orientation, Optional<ICC_Profile> profile, boolean hasProfile) {
    /** Largest chunk, and largest decompressed profile, that is read. */
    private static final int MOST_CHUNK_BYTES = 1 << 22;
    /** Value of PNG's chunk gAMA for sRGB: 1e5 divided by 2.2. */
    private static final int SRGB_GAMMA = 45_455;
    // Tolerance of this value, so that a gamma of 0.45 counts as sRGB, too.
    private static final int GAMMA_ROUNDING = 500;

    /** @throws InputException for damaged tags, and for a PNG whose colors are neither sRGB nor described by a profile */
    static PhotoTags read(Path file) {
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

    private static PhotoTags withoutProfile(Metadata metadata) {
        return new PhotoTags(orientation(metadata), Optional.empty(), false);
    }

    private static PhotoTags ofTiff(Metadata metadata) {
        return new PhotoTags(
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

    private static PhotoTags ofPng(Path file, Map<String, byte[]> chunks) throws IOException {
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
                : new PhotoTags(orientation(metadata), Optional.of(inflatedProfile(profile)), true);
    }

    private static InputException otherColors(Path file, String how) {
        return new InputException(
                "photograph " + file + " has colors coded " + how + "; convert it to sRGB, or embed an ICC profile");
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
