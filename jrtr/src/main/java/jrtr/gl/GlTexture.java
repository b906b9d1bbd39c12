package jrtr.gl;

import jrtr.Texture;

/** What a draw needs to know of a texture of any kind. */
interface GlTexture extends Texture {

    /** GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY. */
    int glTarget();

    /** The texture's name in OpenGL. */
    int glName();

    /** Throws unless a draw on this device may sample it now. */
    void requireReadyFor(GlDevice user);
}
