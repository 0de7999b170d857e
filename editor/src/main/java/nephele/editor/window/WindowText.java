package nephele.editor.window;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the window's frame in English, Brazilian and European Portuguese. */
public enum WindowText implements Text {
    TITLE("Nephele level editor", "Editor de fases Nephele", "Editor de níveis Nephele"),
    UNTITLED("Untitled", "Sem título", "Sem título"),
    TOOLS("Tools", "Ferramentas", "Ferramentas"),
    STATUS("Status", "Estado", "Estado"),
    GRID("Grid %s m", "Grade %s m", "Grelha %s m"),
    GRID_STEP("Step of the grid", "Passo da grade", "Passo da grelha"),
    LAYER_TO_PAINT("Layer to paint", "Camada a pintar", "Camada a pintar"),
    OPTIONS("View and tool options", "Vista e opções da ferramenta", "Vista e opções da ferramenta"),
    SAVE("Save", "Salvar", "Guardar"),
    DISCARD("Don't save", "Não salvar", "Não guardar"),
    READING("Reading files…", "Lendo arquivos…", "A ler ficheiros…"),
    CANCEL("Cancel", "Cancelar", "Cancelar"),
    OK("OK", "OK", "OK"),
    YES("Yes", "Sim", "Sim"),
    NO("No", "Não", "Não"),
    ASK_CLOSE(
            "Save the changes to \"%s\" before closing?",
            "Salvar as alterações de \"%s\" antes de fechar?", "Guardar as alterações de \"%s\" antes de fechar?"),
    PACKAGES("Packages (*.zip)", "Pacotes (*.zip)", "Pacotes (*.zip)"),
    ADDABLE_FILES(
            "Pictures, models, clouds, scenes, levels",
            "Imagens, modelos, nuvens, cenas, fases",
            "Imagens, modelos, nuvens, cenas, níveis"),
    LEVEL_FILES("Levels (*.json, *.zip)", "Fases (*.json, *.zip)", "Níveis (*.json, *.zip)");

    private final Words words;

    WindowText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
