package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class InboxTest {
    private final Inbox<String, String> inbox = new Inbox<>();

    @Test
    void onlyTheNewestStateIsShown() {
        inbox.show("old");
        inbox.show("new");
        assertThat(inbox.state()).contains("new");
        assertThat(inbox.state()).isEmpty();
    }

    @Test
    void noTaskIsForgotten() {
        inbox.submit("one");
        inbox.submit("two");
        assertThat(inbox.task()).contains("one");
        assertThat(inbox.task()).contains("two");
    }

    @Test
    void aNewerStateInterrupts() throws InterruptedException {
        assertThat(inbox.isInterrupted()).isFalse();
        inbox.show("new");
        assertThat(inbox.isInterrupted()).isTrue();
        assertThat(inbox.staysStill(1000)).isFalse();
    }

    @Test
    void withoutNewsAllIsStill() throws InterruptedException {
        assertThat(inbox.staysStill(1)).isTrue();
    }

    @Test
    void closingInterruptsAndWakes() throws InterruptedException {
        inbox.close();
        inbox.await();
        assertThat(inbox.isInterrupted()).isTrue();
        assertThat(inbox.staysStill(1000)).isFalse();
    }
}
