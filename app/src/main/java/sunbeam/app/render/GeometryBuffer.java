package sunbeam.app.render;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.scene.RenderItem;
import jrtr.scene.RenderPass;
import jrtr.scene.View;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.scene.Scene.Viewpoint;

/** Geometry buffer of a block: surface attributes of its pixels. */
record GeometryBuffer(Layout layout, FloatTarget attributes) implements AutoCloseable {
    // Distance of near and far plane from the center of all shapes, in radii; above 1, so that rounding clips nothing.
    private static final float MARGIN = 1.02f;

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

    /**
     * Input of the geometry pass; equal inputs draw equal attributes.
     *
     * @param items shapes in world space
     * @param bounds sphere around the shapes
     */
    record SkinGeometry(List<RenderItem> items, BoundingSphere bounds, Viewpoint view, int width, int height) {
        // Near plane to far plane, for an eye inside the mesh's sphere; suits a 32-bit depth buffer.
        private static final float NEAREST = 1e-3f;
        // Distance of both planes from the mesh's center relative to the eye's, so that float32 separates them.
        private static final float THINNEST = 1e-4f;

        static View view(Viewpoint view, BoundingSphere bounds) {
            Camera camera = view.camera();
            Vector3f sight = camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
            // From the eye to the mesh's center, along the line of sight.
            float distance = bounds.center()
                    .sub(camera.centerOfProjection(), new Vector3f())
                    .dot(sight.normalize());
            float reach = Math.max(MARGIN * bounds.radius(), THINNEST * Math.abs(distance));
            // A mesh behind the eye is invisible with any planes.
            float far = Math.max(distance, 0) + reach;
            float near = Math.max(distance - reach, NEAREST * far);
            return new View(camera, (float) view.verticalFieldOfView(), (float) Viewpoint.LEAST_ASPECT, near, far);
        }

        private View sight() {
            return view(view, bounds);
        }

        void applyRaysTo(ShaderProgram program, Tile block) {
            sight().applyRaysTo(program, new View.Area(width, height, block));
        }

        /** From (x, y, depth) to world space: x and y in pixels from the block's lower left, depth as in the depth buffer. */
        Matrix4f blockToWorld(Tile block) {
            Matrix4f toClip = sight().worldToClip(new View.Area(width, height, block));
            return toClip.invert().translate(-1, -1, -1).scale(2f / block.width(), 2f / block.height(), 2);
        }

        void draw(RenderContext context, ShaderProgram program, FloatTarget target, Tile block) {
            // Then the near plane, and so the eye, is in front of all shapes in any orientation.
            boolean seesFromOutside = sight().near() > NEAREST * sight().far();
            new RenderPass(context, program, Map.of(), seesFromOutside)
                    .draw(
                            items,
                            sight(),
                            new View.Area(width, height, block),
                            target,
                            Tile.whole(block.width(), block.height()));
        }
    }
}
