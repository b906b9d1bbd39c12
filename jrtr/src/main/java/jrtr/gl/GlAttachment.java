package jrtr.gl;

import com.jogamp.opengl.GL3;

/** A target's image as a texture. Lives and dies with its target. */
record GlAttachment(GlFloatTarget owner, int index, int glName) implements GlTexture {

    @Override
    public int glTarget() {
        return GL3.GL_TEXTURE_2D;
    }

    @Override
    public void requireReadyFor(GlDevice user) {
        owner.requireUsableBy(user);
    }

    @Override
    public String label() {
        return owner.label() + "[" + index + "]";
    }

    @Override
    public boolean isArray() {
        return false;
    }
}
