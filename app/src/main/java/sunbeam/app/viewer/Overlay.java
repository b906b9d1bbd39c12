package sunbeam.app.viewer;

public enum Overlay {
    CONE,
    STROKES,
    MAP
}
