package sunbeam.app;

/** Entry point of the {@code sunbeam} command. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        System.exit(0);
    }
}
