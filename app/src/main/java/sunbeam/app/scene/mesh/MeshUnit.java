package sunbeam.app.scene.mesh;

/** Unit of the numbers in a mesh file. */
public enum MeshUnit {
    M(1),
    CM(1e-2),
    MM(1e-3),
    UM(1e-6),
    IN(0.0254);

    private final double meters;

    MeshUnit(double meters) {
        this.meters = meters;
    }

    public double meters() {
        return meters;
    }
}
