package nephele.app.play;

/** The current stage; rejects a change that {@link GameStage#next} does not list. */
final class StageMachine {
    private GameStage current = GameStage.INITIALISING;

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
}
