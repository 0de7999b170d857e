package nephele.editor.action;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;

/**
 * Runs the lines of a script: {@code ACTION key=value …}. A value with spaces stands in double quotes; a line that begins
 * with {@code #} is a comment. A word without {@code =} is the action's first parameter. A line that should change the
 * level and leaves it as it was has failed.
 */
public final class ScriptRunner {
    private static final Words NO_ACTION = Words.of(
            "there is no action '%s': docs/editor-keys.md lists them",
            "não há a ação '%s': docs/editor-keys.md tem a lista",
            "não há a ação '%s': docs/editor-keys.md tem a lista");
    private static final Words NO_PARAMETER =
            Words.of("%s has no '%s': it takes %s", "%s não tem '%s': aceita %s", "%s não tem '%s': aceita %s");
    private static final Words NOT_NOW = Words.of(
            "%s is not possible now: nothing fitting is selected or there is nothing to undo",
            "%s não é possível agora: nada adequado está selecionado ou não há o que desfazer",
            "%s não é possível agora: nada adequado está selecionado ou não há o que anular");
    private static final Words NOTHING = Words.of(
            "%s changed nothing: everything is so already, or it does not apply to what is selected",
            "%s não mudou nada: tudo já está assim, ou não se aplica ao que está selecionado",
            "%s não mudou nada: tudo já está assim, ou não se aplica ao que está selecionado");
    private static final Words NO_WINDOW = Words.of(
            "%s needs a window, which a script does not have",
            "%s precisa de uma janela, que um script não tem", "%s precisa de uma janela, que um script não tem");
    private static final Words TWICE = Words.of(
            "%s is given twice: write it once",
            "%s aparece duas vezes: escreva só uma", "%s aparece duas vezes: escreve só uma");
    private static final Words OPEN_QUOTE =
            Words.of("a \" is missing at the end", "falta um \" no fim", "falta um \" no fim");

    private final EditorSession session;
    private final UserInterface ui;

    public ScriptRunner(EditorSession session, UserInterface ui) {
        this.session = session;
        this.ui = ui;
    }

    /**
     * Runs one line.
     *
     * @throws EditorRefusal with the reason if it could not be done
     */
    public void run(String line) throws EditorRefusal {
        List<String> words = words(line);
        if (words.isEmpty() || words.get(0).startsWith("#")) {
            return;
        }
        EditorAction action =
                Actions.named(words.get(0)).orElseThrow(() -> new EditorRefusal(NO_ACTION.with(words.get(0))));
        Map<String, String> arguments = arguments(action, words.subList(1, words.size()));
        if (!action.isEnabled().test(session)) {
            throw new EditorRefusal(NOT_NOW.with(action.id()));
        }
        if (action.subject() == Subject.WINDOW && !ui.hasUser()) {
            throw new EditorRefusal(NO_WINDOW.with(action.id()));
        }
        Level before = session.document().level();
        DocumentFile file = session.file();
        action.run(new ActionCall(session, ui, arguments));
        boolean isSame = session.document().level().equals(before) && session.file() == file;
        if (action.subject() == Subject.LEVEL && isSame) {
            throw new EditorRefusal(NOTHING.with(action.id()));
        }
    }

    private static Map<String, String> arguments(EditorAction action, List<String> words) throws EditorRefusal {
        Map<String, String> arguments = new LinkedHashMap<>();
        for (String word : words) {
            int equals = word.indexOf('=');
            boolean isFirst =
                    equals < 0 && arguments.isEmpty() && !action.parameters().isEmpty();
            String name = isFirst ? action.parameters().get(0) : word.substring(0, Math.max(0, equals));
            if (!action.parameters().contains(name)) {
                throw new EditorRefusal(NO_PARAMETER.with(action.id(), word, action.parameters()));
            }
            if (arguments.put(name, isFirst ? word : word.substring(equals + 1)) != null) {
                throw new EditorRefusal(TWICE.with(name));
            }
        }
        return arguments;
    }

    private static List<String> words(String line) throws EditorRefusal {
        List<String> words = new ArrayList<>();
        StringBuilder word = new StringBuilder();
        boolean isQuoted = false;
        boolean isWord = false;
        for (char c : line.toCharArray()) {
            if (c == '"') {
                isQuoted = !isQuoted;
                isWord = true;
            } else if (Character.isWhitespace(c) && !isQuoted) {
                if (isWord) {
                    words.add(word.toString());
                }
                word.setLength(0);
                isWord = false;
            } else {
                word.append(c);
                isWord = true;
            }
        }
        if (isQuoted) {
            throw new EditorRefusal(OPEN_QUOTE);
        }
        if (isWord) {
            words.add(word.toString());
        }
        return words;
    }
}
