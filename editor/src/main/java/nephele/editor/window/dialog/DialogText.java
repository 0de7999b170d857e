package nephele.editor.window.dialog;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the dialogues in English, Brazilian and European Portuguese. */
public enum DialogText implements Text {
    OK("OK", "OK", "OK"),
    CANCEL("Cancel", "Cancelar", "Cancelar"),
    SEARCH_COMMANDS("Search commands", "Buscar comandos", "Procurar comandos"),
    OPEN_RECENT("Open Recent", "Abrir recente", "Abrir recente"),
    SEARCH_KINDS("Search what to add", "Buscar o que adicionar", "Procurar o que adicionar"),
    SEARCH_FILES("Search files", "Buscar arquivos", "Procurar ficheiros"),
    NOTHING_FOUND("Nothing found", "Nada encontrado", "Nada encontrado"),
    RESULTS("Results", "Resultados", "Resultados"),
    ADD("Add", "Adicionar", "Adicionar"),
    CHOOSE_ASSET("Choose a file", "Escolher um arquivo", "Escolher um ficheiro"),
    NO_NUMBER(
            "%s: write a number, or a sum such as 128/3",
            "%s: escreva um número, ou uma conta como 128/3", "%s: escreve um número, ou uma conta como 128/3"),
    IS_EMPTY("%s: write a value", "%s: escreva um valor", "%s: escreve um valor"),
    NO_SUCH(
            "there is no %s here: choose one of %s",
            "não há %s aqui: escolha entre %s", "não há %s aqui: escolhe entre %s"),
    NONE_THERE(
            "there is no %s here, nor another one: add it first",
            "não há %s aqui, nem outro: adicione-o antes", "não há %s aqui, nem outro: adiciona-o antes"),
    RENAME("Rename", "Renomear", "Mudar o nome"),
    NEW_ID("New id", "Novo id", "Novo id"),
    MOVE("Move", "Mover", "Mover"),
    MOVE_BY("By (m)", "Quanto (m)", "Quanto (m)"),
    TURN("Turn", "Girar", "Rodar"),
    AXIS("Axis", "Eixo", "Eixo"),
    DEGREES("Angle (°)", "Ângulo (°)", "Ângulo (°)"),
    SCALE("Scale", "Escalar", "Escalar"),
    FACTORS("Factors", "Fatores", "Fatores"),
    SET("Set a value", "Definir um valor", "Definir um valor"),
    FIELD("Field", "Campo", "Campo"),
    VALUE("Value", "Valor", "Valor"),
    DRAW("Draw brush", "Desenhar bloco", "Desenhar bloco"),
    SHAPE("Shape", "Forma", "Forma"),
    FIRST_CORNER("First corner (m)", "Primeiro canto (m)", "Primeiro canto (m)"),
    SECOND_CORNER("Second corner (m)", "Segundo canto (m)", "Segundo canto (m)"),
    GO_TO("Go to coordinates", "Ir para coordenadas", "Ir para coordenadas"),
    PLACE("Place (m)", "Lugar (m)", "Lugar (m)"),
    YAW("Yaw (°)", "Guinada (°)", "Rumo (°)"),
    PITCH("Pitch (°)", "Arfagem (°)", "Inclinação (°)"),
    GRID("Grid", "Grade", "Grelha"),
    GRID_STEP("Step", "Passo", "Passo"),
    PICTURES("Pictures (*.png)", "Imagens (*.png)", "Imagens (*.png)");

    private final Words words;

    DialogText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
