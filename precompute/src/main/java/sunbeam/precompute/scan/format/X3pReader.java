package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * ISO 25178-72 .x3p: a zip archive with main.xml and the samples as a binary member, from the top row, metres. Only the
 * members that main.xml needs are opened, inside the archive, and never more of them than the size of the matrix asks
 * for: an archive that unpacks to terabytes is not unpacked. NaN and, where there is a list of valid points, its zeros
 * mark missing samples.
 */
final class X3pReader implements ScanReader {
    @Override
    public String format() {
        return "ISO 25178-72 (.x3p)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        if (!file.startsWith("PK\u0003\u0004")) {
            return false;
        }
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            return archive.getEntry(X3pHeader.NAME) != null;
        } catch (IOException | IllegalArgumentException broken) {
            return false;
        }
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        X3pHeader header;
        try (ZipFile archive = new ZipFile(file.path().toFile());
                InputStream in = member(archive, X3pHeader.NAME)) {
            header = X3pHeader.read(in);
            if (!header.pointData().isEmpty()) {
                requireMember(archive, header);
            }
        } catch (IOException damaged) {
            throw broken(damaged);
        }
        Extent extent = Extent.ofPitches(header.pitchX(), header.pitchY(), "m", header.columns(), header.rows());
        return List.of(new ScanChannel(
                "Topography", header.columns(), header.rows(), extent, "m", () -> samples(file, header)));
    }

    private static void requireMember(ZipFile archive, X3pHeader header) {
        ZipEntry entry = archive.getEntry(header.pointData());
        long needed = (long) header.columns() * header.rows() * header.type().size();
        if (entry == null || entry.getSize() < needed) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %s bytes of samples where %d x %d take %d; copy or export it again",
                    entry == null ? "no" : entry.getSize(),
                    header.columns(),
                    header.rows(),
                    needed));
        }
    }

    private static InputStream member(ZipFile archive, String name) throws IOException {
        ZipEntry entry = archive.getEntry(name);
        if (entry == null || entry.isDirectory()) {
            throw new ScanException(String.format(Locale.ROOT, "has no member %s; copy or export it again", name));
        }
        return archive.getInputStream(entry);
    }

    private static double[] samples(ScanBytes file, X3pHeader header) throws IOException {
        long count = (long) header.columns() * header.rows();
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            double[] samples;
            if (header.pointData().isEmpty()) {
                try (InputStream in = member(archive, X3pHeader.NAME)) {
                    samples = X3pHeader.dataList(in, count);
                }
            } else {
                SampleBlock block = new SampleBlock(0, count, header.type(), ByteOrder.LITTLE_ENDIAN);
                try (InputStream in = member(archive, header.pointData())) {
                    samples = block.read(in);
                }
            }
            if (!header.validPoints().isEmpty()) {
                try (InputStream in = member(archive, header.validPoints())) {
                    dropInvalid(samples, in);
                }
            }
            return Samples.scaled(samples, header.stepZ(), header.offsetZ());
        } catch (IOException damaged) {
            throw broken(damaged);
        }
    }

    private static ScanException broken(IOException damaged) {
        return new ScanException(
                "is a damaged archive (" + damaged.getMessage() + "); copy or export it again", damaged);
    }

    /** One bit a sample, the lowest bit of a byte first; 0 where there is none. */
    private static void dropInvalid(double[] samples, InputStream in) throws IOException {
        byte[] bits = in.readNBytes((samples.length + 7) / 8);
        for (int i = 0; i < samples.length && i / 8 < bits.length; i++) {
            if ((bits[i / 8] >> i % 8 & 1) == 0) {
                samples[i] = Double.NaN;
            }
        }
    }
}
