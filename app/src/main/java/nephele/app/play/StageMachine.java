package nephele.app.play;

/** The current stage; rejects a change that {@link Stage#next} does not list. */
final class StageMachine {
    private Stage current = Stage.INITIALISING;

    Stage current() {
        return current;
    }

    boolean in(Stage stage) {
        return current == stage;
    }

    void change(Stage to) {
        if (!current.next().contains(to)) {
            throw new IllegalStateException("the game can't go from " + current + " to " + to);
        }
        current = to;
    }
}
