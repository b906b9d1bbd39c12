package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;

/** What OpenGL itself still has, whoever made it: asked for when a context ends, when it must be nothing. */
final class LivingObjects {
    /** Drivers count names from 1 and take those of deleted objects again; more at once nothing here makes. */
    private static final int MOST_NAMES = 1024;

    private LivingObjects() {}

    /** Number of objects by kind; kinds without any are left out. The context is current. */
    static Map<String, Integer> of(GL3 gl) {
        Map<String, Integer> living = new TreeMap<>();
        count(living, "textures", gl::glIsTexture);
        count(living, "buffers", gl::glIsBuffer);
        count(living, "framebuffers", gl::glIsFramebuffer);
        count(living, "renderbuffers", gl::glIsRenderbuffer);
        count(living, "programs", gl::glIsProgram);
        count(living, "shaders", gl::glIsShader);
        count(living, "queries", gl::glIsQuery);
        count(living, "samplers", gl::glIsSampler);
        // One is JOGL's own, since core contexts have none to begin with; it goes with the context.
        int ofJogl = gl.getContext().getDefaultVAO();
        count(living, "vertex arrays", name -> name != ofJogl && gl.glIsVertexArray(name));
        return living;
    }

    private static void count(Map<String, Integer> living, String kind, IntPredicate exists) {
        for (int name = 1; name <= MOST_NAMES; name++) {
            if (exists.test(name)) {
                living.merge(kind, 1, Integer::sum);
            }
        }
    }
}
