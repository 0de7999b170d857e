package nephele.app.play;

import java.io.PrintStream;

/** Writes one line for each change of what the player sees, for {@code --verbose}. */
final class StageLog {
    private final PrintStream err;
    private String last = "";

    /** @param err {@code null} for no lines */
    StageLog(PrintStream err) {
        this.err = err;
    }

    /** Writes the state that the picture shows, if it is another one than before; a menu once it takes input. */
    void shown(GameStage stage, MenuControl menu, Loading loading, CurrentLevel current) {
        if (err == null || menu.page() != null && menu.isDeaf()) {
            return;
        }
        switch (stage) {
            case TITLE, MENU, ENDED -> {
                String page = menu.page().name();
                say("title".equals(page) ? "title" : "menu " + page);
            }
            case STARTING -> say("loading " + loading.request().level().fileName());
            case RUNNING -> say("playing " + current.session().request().level().fileName());
            default -> {}
        }
    }

    void say(String state) {
        if (err != null && !state.equals(last)) {
            last = state;
            err.println("state " + state);
        }
    }
}
