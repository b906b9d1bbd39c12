package jrtr.scene;

import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Map;
import jrtr.BoundingSphere;
import jrtr.ShaderProgram;
import jrtr.VertexBuffer;
import org.joml.Vector3f;

/** Shapes that can be sorted and culled, but not drawn. */
final class FakeShapes {
    private FakeShapes() {}

    private record Ball(String label, BoundingSphere bounds) implements VertexBuffer {
        @Override
        public boolean isClosed() {
            return false;
        }

        @Override
        public void close() {}
    }

    /** A shape in a sphere about the origin. */
    static Shape ball(String label, float radius) {
        Object program = Proxy.newProxyInstance(
                FakeShapes.class.getClassLoader(), new Class<?>[] {ShaderProgram.class}, (proxy, method, arguments) -> {
                    throw new UnsupportedOperationException("a fake program has no " + method.getName());
                });
        return new Shape(
                new Ball(label, new BoundingSphere(new Vector3f(), radius)),
                new Material((ShaderProgram) program, List.of(), Map.of()));
    }
}
