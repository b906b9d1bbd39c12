package sunbeam.precompute.scan;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;

/**
 * Samples that lie in a file one after the other.
 *
 * @param offset of the first, bytes
 * @param count how many
 */
public record SampleBlock(long offset, long count, SampleType type, ByteOrder order) {
    private static final int BUFFER_SAMPLES = 1 << 15;

    /**
     * A block that the file has, as {@link ScanChannel}s read it.
     *
     * @throws ScanException when the file ends before it does, so that a header cannot ask for more than is there
     */
    public static ScanChannel.Source of(ScanBytes file, long offset, long count, SampleType type, ByteOrder order) {
        SampleBlock block = new SampleBlock(offset, count, type, order).requireIn(file);
        return () -> block.read(file.stream(offset));
    }

    /** Bytes of all. */
    public long bytes() {
        return Math.multiplyExact(count, type.size());
    }

    /**
     * The same, when the file has it.
     *
     * @throws ScanException otherwise
     */
    public SampleBlock requireIn(ScanBytes file) {
        if (count < 0 || count > Long.MAX_VALUE / type.size()) {
            throw new ScanException(
                    String.format(Locale.ROOT, "claims %d samples; the file is damaged, export it again", count));
        }
        file.requireInside(offset, bytes());
        return this;
    }

    /**
     * The samples of a stream that stands at the first of them, as stored, without any scale.
     *
     * @throws ScanException when the stream ends too early
     */
    public double[] read(InputStream in) throws IOException {
        double[] samples = new double[Math.toIntExact(count)];
        byte[] bytes = new byte[BUFFER_SAMPLES * type.size()];
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(order);
        for (int first = 0; first < samples.length; first += BUFFER_SAMPLES) {
            int wanted = Math.min(BUFFER_SAMPLES, samples.length - first);
            if (in.readNBytes(bytes, 0, wanted * type.size()) < wanted * type.size()) {
                throw new ScanException(String.format(
                        Locale.ROOT, "ends before the last of its %d samples; copy or export it again", count));
            }
            type.decode(buffer, samples, first, wanted);
        }
        return samples;
    }
}
