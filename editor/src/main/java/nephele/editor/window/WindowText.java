package nephele.editor.window;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the window's frame in English, Brazilian and European Portuguese. */
public enum WindowText implements Text {
    TITLE("Nephele level editor", "Editor de níveis Nephele", "Editor de níveis Nephele"),
    UNTITLED("Untitled", "Sem título", "Sem título"),
    TOOLS("Tools", "Ferramentas", "Ferramentas"),
    MAIN_ACTIONS("Main actions", "Ações principais", "Ações principais"),
    STATUS("Status", "Estado", "Estado"),
    GRID("Grid %s m", "Grade %s m", "Grelha %s m"),
    SEARCH("Search commands", "Buscar comandos", "Procurar comandos"),
    NOTHING_FOUND("Nothing found", "Nada encontrado", "Nada encontrado"),
    SAVE("Save", "Salvar", "Guardar"),
    DISCARD("Don't save", "Não salvar", "Não guardar"),
    CANCEL("Cancel", "Cancelar", "Cancelar"),
    YES("Yes", "Sim", "Sim"),
    NO("No", "Não", "Não"),
    ASK_CLOSE(
            "Save the changes to \"%s\" before closing?",
            "Salvar as alterações de \"%s\" antes de fechar?", "Guardar as alterações de \"%s\" antes de fechar?"),
    LEVEL_FILES("Levels (*.json, *.zip)", "Níveis (*.json, *.zip)", "Níveis (*.json, *.zip)");

    private final Words words;

    WindowText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
