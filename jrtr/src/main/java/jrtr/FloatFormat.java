package jrtr;

/** Formats of float textures. A shader reads channels that a format lacks as 0, alpha as 1. */
public enum FloatFormat {
    R32F(1, Float.BYTES),
    /** Two channels, such as a complex number. */
    RG32F(2, Float.BYTES),
    RGBA32F(4, Float.BYTES),
    /** Four channels of 16 bits (IEEE 754's binary16). */
    RGBA16F(4, Short.BYTES);

    private final int channels;
    private final int bytesPerChannel;

    FloatFormat(int channels, int bytesPerChannel) {
        this.channels = channels;
        this.bytesPerChannel = bytesPerChannel;
    }

    public int channels() {
        return channels;
    }

    public int bytesPerChannel() {
        return bytesPerChannel;
    }
}
