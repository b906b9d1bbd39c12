package sunbeam.app.render;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import sunbeam.app.gpu.Shaders;

/** Geometry buffer of a block: surface attributes of its pixels. */
record GeometryBuffer(Layout layout, FloatTarget attributes) implements AutoCloseable {

    /** Keys are the names of the shading pass's samplers. */
    Map<String, Texture> textures() {
        Map<String, Texture> textures = new HashMap<>();
        for (String sampler : layout.samplers) {
            textures.put(sampler, attributes.texture(textures.size()));
        }
        return textures;
    }

    /** Full layout only: direction to the viewer, and the patch's number ({@link SceneData#patchNumber}), 0 without skin; top row first. */
    float[] views(Tile part) {
        return attributes.read(0, part);
    }

    /** Full layout only: the patch's x axis in world space, and the visible share of the sky; top row first. */
    float[] tangents(Tile part) {
        return attributes.read(2, part);
    }

    /** Index of a texel as in shaders/skin.frag, row by row from the bottom left; x and y count from the block's top left. */
    int texel(int x, int y) {
        return (attributes.spec().height() - 1 - y) * attributes.spec().width() + x;
    }

    @Override
    public void close() {
        attributes.close();
    }

    enum Layout {
        /** All attributes in single precision (shaders/geometry.frag); with depth 68 bytes per pixel. */
        FULL("geometry.frag", "views", "normals", "tangents", "albedos"),
        /** Packed attributes for moving pictures (shaders/moving_geometry.frag); with depth 20 bytes per pixel. */
        MOVING("moving_geometry.frag", "surfaces");

        private final String shader;

        @SuppressWarnings("ImmutableEnumChecker") // a private copy
        private final List<String> samplers;

        Layout(String shader, String... samplers) {
            this.shader = shader;
            this.samplers = List.of(samplers);
        }
    }

    /** LRU cache of a picture's blocks (deferred shading; Saito and Takahashi 1990), valid for one {@link SkinGeometry}. */
    static final class Cache implements AutoCloseable {
        /** Blocks of a picture of 2048 x 2048 pixels, which take 290 MB. */
        static final int CAPACITY = 4;

        private final RenderContext context;
        private final Layout layout;
        private final ShaderProgram program;
        private final Map<Tile, GeometryBuffer> buffers = new LinkedHashMap<>(2 * CAPACITY, 0.75f, true);
        private final Set<Tile> drawn = new HashSet<>();
        private SkinGeometry geometry;

        Cache(RenderContext context, Layout layout) {
            this.context = context;
            this.layout = layout;
            this.program = context.createMeshProgram(Shaders.library().load(layout.shader));
        }

        /** Returns a block's buffer, drawn if necessary; valid until the next call. */
        GeometryBuffer of(SkinGeometry wanted, Tile block) {
            if (!wanted.equals(geometry)) {
                drawn.clear();
                if (geometry != null && (wanted.width() != geometry.width() || wanted.height() != geometry.height())) {
                    closeBuffers();
                }
                geometry = wanted;
            }
            GeometryBuffer buffer = buffers.get(block);
            if (buffer == null) {
                buffer = newBuffer(block);
                buffers.put(block, buffer);
            }
            // The draw of each part would process all vertices.
            if (!drawn.contains(block)) {
                geometry.draw(context, program, buffer.attributes(), block);
                drawn.add(block);
                // Geometry pass and shading pass are timed separately, except in moving pictures.
                if (layout == Layout.FULL) {
                    context.finish();
                }
            }
            return buffer;
        }

        /** Returns the oldest buffer again if the cache is full and it has the block's size: new memory takes time. */
        private GeometryBuffer newBuffer(Tile block) {
            if (buffers.size() == CAPACITY) {
                Tile oldest = buffers.keySet().iterator().next();
                GeometryBuffer free = buffers.remove(oldest);
                drawn.remove(oldest);
                if (oldest.width() == block.width() && oldest.height() == block.height()) {
                    return free;
                }
                free.close();
            }
            var spec = new FloatTarget.Spec(block.width(), block.height(), layout.samplers.size(), true);
            return new GeometryBuffer(layout, context.createFloatTarget("geometry", spec));
        }

        private void closeBuffers() {
            buffers.values().forEach(GeometryBuffer::close);
            buffers.clear();
        }

        @Override
        public void close() {
            closeBuffers();
            program.close();
        }
    }
}
