package sunbeam.app.render;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.View;
import sunbeam.app.gpu.Shaders;

/**
 * LRU cache of the geometry buffers of a picture's blocks (deferred shading; Saito and Takahashi 1990). The buffers stay valid while the
 * scene's {@link SkinGeometry} is the same.
 */
final class GeometryBuffers implements AutoCloseable {
    /** Capacity in blocks: those of a picture of 2048 x 2048 pixels, which take 290 MB. */
    static final int CAPACITY = 4;

    private final RenderContext context;
    private final GeometryBuffer.Layout layout;
    private final ShaderProgram program;
    private final Map<Tile, GeometryBuffer> buffers = new LinkedHashMap<>(2 * CAPACITY, 0.75f, true);
    private final Set<Tile> drawn = new HashSet<>();
    private SkinGeometry geometry;

    GeometryBuffers(RenderContext context, GeometryBuffer.Layout layout) {
        this.context = context;
        this.layout = layout;
        this.program = context.createMeshProgram(Shaders.library().load(layout.shader()));
    }

    /** Returns a block's buffer, drawn if necessary; valid until the next call. */
    GeometryBuffer of(SkinGeometry wanted, Tile block) {
        changeTo(wanted);
        GeometryBuffer buffer = buffers.get(block);
        if (buffer == null) {
            buffer = newBuffer(block);
            buffers.put(block, buffer);
        }
        // Draws the whole block at once, since the draw of each part would process all vertices.
        if (!drawn.contains(block)) {
            View.Area area = new View.Area(geometry.width(), geometry.height(), block);
            geometry.graph(program).draw(context, area, buffer.attributes(), Tile.whole(block.width(), block.height()));
            drawn.add(block);
            // Waits, so that geometry pass and shading pass are timed separately. Moving pictures have no time for
            // that.
            if (layout == GeometryBuffer.Layout.FULL) {
                context.finish();
            }
        }
        return buffer;
    }

    private void changeTo(SkinGeometry wanted) {
        if (wanted.equals(geometry)) {
            return;
        }
        drawn.clear();
        if (geometry == null || wanted.width() != geometry.width() || wanted.height() != geometry.height()) {
            closeBuffers();
        }
        geometry = wanted;
    }

    /** Returns the oldest buffer again if there is no room for another and it is as large as the block: new memory takes time. */
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
        return GeometryBuffer.create(context, layout, block);
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
