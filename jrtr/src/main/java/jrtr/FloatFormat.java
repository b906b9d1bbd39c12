package jrtr;

/** 32-bit float texels. Channels that a format lacks read as 0, alpha as 1. */
public enum FloatFormat {
    /** One channel. */
    R32F(1),
    /** Two channels, such as a complex number. */
    RG32F(2),
    /** Four channels. */
    RGBA32F(4);

    private final int channels;

    FloatFormat(int channels) {
        this.channels = channels;
    }

    /** Floats per texel. */
    public int channels() {
        return channels;
    }
}
