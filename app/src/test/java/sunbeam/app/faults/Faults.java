package sunbeam.app.faults;

import java.io.IOException;

/** Decides which call to a file system fails, and counts them all. */
final class Faults {
    /** What happens at the chosen call. */
    enum Kind {
        /** This call fails and later ones work: a full disk, a network that was away. */
        ERROR,
        /** Neither this call nor any later one is done, tidying up included: the process was killed. */
        KILL
    }

    /** Nothing in the program may catch this: a killed process does nothing more. */
    static final class Killed extends Error {
        private static final long serialVersionUID = 1;

        Killed(String operation) {
            super("killed at " + operation);
        }
    }

    private final Kind kind;
    private final long chosen;
    private long calls;
    private boolean armed;
    private String failed = "nothing failed";

    /** @param chosen the call that fails, from 1 */
    Faults(Kind kind, long chosen) {
        this.kind = kind;
        this.chosen = chosen;
    }

    /** From now on calls count. */
    void arm() {
        armed = true;
    }

    /** Calls work again, for a look at what is left. */
    void disarm() {
        armed = false;
    }

    /** Whether the chosen call was ever made. */
    boolean happened() {
        return calls >= chosen;
    }

    /** Whether it was a deletion that failed. */
    boolean hitDeletion() {
        return failed.startsWith("delete");
    }

    /** To be called before each call is done. */
    void beforeCall(String operation) throws IOException {
        if (!armed) {
            return;
        }
        calls++;
        if (calls == chosen) {
            failed = operation;
        }
        if (kind == Kind.KILL && calls >= chosen) {
            throw new Killed(operation);
        }
        if (calls == chosen) {
            throw new IOException("injected fault at " + operation);
        }
    }

    /** Whether the next call is the one that fails, so that a writer may do half of it first. */
    boolean isNext() {
        return armed && calls + 1 == chosen;
    }

    /** The call that failed. */
    @Override
    public String toString() {
        return kind + " at call " + chosen + ": " + failed;
    }
}
