package nephele.app.play;

import java.io.PrintStream;

/**
 * The current stage; rejects a change that {@link GameStage#next} does not list. With {@code --verbose} it writes one line for
 * each change of what the player sees.
 */
final class StageMachine {
    private final PrintStream err;
    private String lastLine = "";
    private GameStage current = GameStage.INITIALISING;

    /** @param err {@code null} for no lines */
    StageMachine(PrintStream err) {
        this.err = err;
    }

    GameStage current() {
        return current;
    }

    boolean in(GameStage stage) {
        return current == stage;
    }

    /** Returns true in the stages with an open menu. */
    boolean inMenu() {
        return in(GameStage.TITLE) || in(GameStage.MENU) || in(GameStage.ENDED);
    }

    void change(GameStage to) {
        if (!current.next().contains(to)) {
            throw new IllegalStateException("the game can't go from " + current + " to " + to);
        }
        current = to;
    }

    /** Writes the state that the picture shows, if it is another one than before; a menu once it takes input. */
    void logVisible(MenuControl menu, Loading loading, CurrentLevel level) {
        if (err == null || menu.page() != null && menu.isDeaf()) {
            return;
        }
        switch (current) {
            case TITLE, MENU, ENDED -> {
                String page = menu.page().name();
                log("title".equals(page) ? "title" : "menu " + page);
            }
            case STARTING -> log("loading " + loading.request().level().fileName());
            case RUNNING -> log("playing " + level.session().request().level().fileName());
            default -> {}
        }
    }

    void log(String state) {
        if (err != null && !state.equals(lastLine)) {
            lastLine = state;
            err.println("state " + state);
        }
    }
}
