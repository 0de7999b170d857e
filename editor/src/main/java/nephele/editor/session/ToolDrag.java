package nephele.editor.session;

import nephele.editor.tool.Pointer;

/**
 * The drag of the tool in use, from the press of the button to its release. What changes the document in between (a
 * command, another panel, a file that changed on disk) cancels it, so that no tool goes on from a level that is gone;
 * the rest of the movement then does nothing.
 */
public final class ToolDrag {
    private final EditorSession session;
    private boolean isOn;
    /** True while the tool itself may change the document. */
    private boolean isToolAtWork;

    ToolDrag(EditorSession session) {
        this.session = session;
        session.document().listen((before, after) -> {
            if (isOn && !isToolAtWork) {
                cancel();
            }
        });
    }

    /** Returns true while the button is held and nothing has cancelled the drag. */
    public boolean isOn() {
        return isOn;
    }

    /** Begins a drag. */
    public void press(Pointer pointer) {
        isOn = true;
        work(() -> session.tool().pressed(pointer));
    }

    /** Goes on with the drag; does nothing if it was cancelled. */
    public void move(Pointer pointer) {
        if (isOn) {
            work(() -> session.tool().dragged(pointer));
        }
    }

    /** Ends the drag; does nothing if it was cancelled. */
    public void release(Pointer pointer) {
        if (isOn) {
            isOn = false;
            work(() -> session.tool().released(pointer));
        }
    }

    private void work(Runnable step) {
        isToolAtWork = true;
        try {
            step.run();
        } finally {
            isToolAtWork = false;
        }
    }

    /** Returns true if the tool or a field of the inspector shows what is not a step yet. */
    public boolean isShowing() {
        return isOn || session.document().isDragging();
    }

    /** Makes the document exactly as before the drag, of a field of the inspector too; returns false without one. */
    public boolean cancel() {
        boolean isCancelled = isShowing();
        if (isOn) {
            isOn = false;
            session.tool().cancel();
        }
        session.document().cancelDrag();
        return isCancelled;
    }
}
