package nephele.editor.action;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import nephele.editor.document.Registration;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;

/**
 * An action of the editor: its names, its place in the menus, its keys, and its effect.
 *
 * @param id its name in scripts and in the settings' key bindings
 * @param keys default keys as {@code KeyText} reads them, such as {@code Ctrl+Shift+D}
 * @param parameters keys that a script line may give, each with its meaning, such as {@code by=x,y,z}
 * @param isChosen true while the choice that it makes holds; false for an action that makes none
 * @param subject what it is there to change; a script holds it to that
 */
public record EditorAction(
        String id,
        Words title,
        Menu menu,
        List<String> keys,
        List<String> parameters,
        Predicate<EditorSession> isEnabled,
        Predicate<EditorSession> isChosen,
        Effect effect,
        Subject subject) {
    /** What an action changes. */
    public enum Subject {
        /** The level: a line of a script that leaves it as it was has failed. */
        LEVEL,
        /** What is selected, seen or chosen, and files: one that is added may be in the level already. */
        SESSION,
        /** A part of the window, or the game in its window: a script has neither. */
        WINDOW
    }

    /** The menus, in the order of the menu bar. */
    public enum Menu {
        FILE(Words.of("File", "Arquivo", "Ficheiro")),
        EDIT(Words.of("Edit", "Editar", "Editar")),
        SELECT(Words.of("Select", "Selecionar", "Selecionar")),
        BRUSH(Words.of("Brush", "Bloco", "Bloco")),
        TERRAIN(Words.of("Terrain", "Terreno", "Terreno")),
        VIEW(Words.of("View", "Exibir", "Ver")),
        TOOL(Words.of("Tool", "Ferramenta", "Ferramenta")),
        PLAY(Words.of("Play", "Jogar", "Jogar")),
        PROVE(Words.of("Prove", "Provar", "Provar")),
        WINDOW(Words.of("Window", "Janela", "Janela")),
        HELP(Words.of("Help", "Ajuda", "Ajuda"));

        private final Words title;

        Menu(Words title) {
            this.title = title;
        }

        public Words title() {
            return title;
        }
    }

    /** The effect of an action. */
    @FunctionalInterface
    public interface Effect {
        /**
         * Does it.
         *
         * @throws EditorRefusal with a message for the user
         */
        void run(ActionCall call) throws EditorRefusal;
    }

    /**
     * Does it, after {@link #endDrag}.
     *
     * @throws EditorRefusal with a message for the user
     */
    public void run(ActionCall call) throws EditorRefusal {
        if (!endDrag(call.session())) {
            return;
        }
        List<Words> refusals = new ArrayList<>();
        Registration listening = call.session().document().onRefusal(refusals::add);
        try {
            effect.run(call);
        } finally {
            listening.close();
        }
        if (!refusals.isEmpty()) {
            throw new EditorRefusal(refusals.get(0));
        }
    }

    /**
     * Ends a drag, since an action must not work on what a drag only shows; but the view may change meanwhile, and undo
     * takes back the drag itself.
     *
     * @return false if the level before the drag leaves nothing to do
     */
    public boolean endDrag(EditorSession session) {
        boolean goesOn = menu == Menu.VIEW || menu == Menu.WINDOW || id.equals("undo");
        return goesOn || !session.drag().cancel() || isEnabled.test(session);
    }

    /** Returns an action of the session without parameters that is always possible. */
    static EditorAction of(String id, Words title, Menu menu, List<String> keys, Effect effect) {
        return new EditorAction(
                id, title, menu, keys, List.of(), session -> true, session -> false, effect, Subject.SESSION);
    }

    /** Returns this action, possible only if a condition holds. */
    EditorAction when(Predicate<EditorSession> condition) {
        return new EditorAction(id, title, menu, keys, parameters, condition, isChosen, effect, subject);
    }

    /** Returns this action, chosen while a condition holds. */
    EditorAction chosenWhen(Predicate<EditorSession> condition) {
        return new EditorAction(id, title, menu, keys, parameters, isEnabled, condition, effect, subject);
    }

    /** Returns this action with default keys. */
    EditorAction keyed(String... defaults) {
        return new EditorAction(id, title, menu, List.of(defaults), parameters, isEnabled, isChosen, effect, subject);
    }

    /** Returns this action with parameters. */
    EditorAction taking(String... names) {
        return new EditorAction(id, title, menu, keys, List.of(names), isEnabled, isChosen, effect, subject);
    }

    /** Returns this action, which changes something else than the session. */
    EditorAction changing(Subject other) {
        return new EditorAction(id, title, menu, keys, parameters, isEnabled, isChosen, effect, other);
    }
}
