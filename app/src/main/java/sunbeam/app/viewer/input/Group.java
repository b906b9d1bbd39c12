package sunbeam.app.viewer.input;

/** Group of mouse and key actions, in the order of the help. A group with a menu offers its key actions there. */
enum Group {
    LIGHT("Turning and light", false),
    CAMERA("Camera", false),
    SKIN("Points and methods", false),
    FILE("File", true),
    EDIT("Edit", true),
    VIEW("View", true),
    HELP("Help", true);

    private final String title;
    private final boolean hasMenu;

    Group(String title, boolean hasMenu) {
        this.title = title;
        this.hasMenu = hasMenu;
    }

    String title() {
        return title;
    }

    boolean hasMenu() {
        return hasMenu;
    }
}
