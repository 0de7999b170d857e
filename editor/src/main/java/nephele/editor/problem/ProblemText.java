package nephele.editor.problem;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the problems panel in English, Brazilian and European Portuguese. */
public enum ProblemText implements Text {
    NO_START(
            "the level has no start: the player cannot play it",
            "a fase não tem início: não dá para jogar",
            "o nível não tem início: não se pode jogar"),
    NO_EXIT(
            "the level has no exit: it never ends",
            "a fase não tem saída: ela nunca termina",
            "o nível não tem saída: nunca acaba"),
    OPEN_TO_OUTSIDE(
            "from the start one gets out of the level here; if it is meant to be open, hide this",
            "do início dá para sair da fase por aqui; se for de propósito, oculte isto",
            "do início pode-se sair do nível por aqui; se for de propósito, oculta isto"),
    DELETE("Delete %s", "Excluir %s", "Eliminar %s"),
    RENAME("Rename to %s", "Renomear para %s", "Mudar o nome para %s"),
    USE_NO_MATERIAL("Use the default grey", "Usar o cinza padrão", "Usar o cinzento predefinido"),
    CREATE_MATERIAL("Create the material %s", "Criar o material %s", "Criar o material %s"),
    REMOVE_FILE("Do without the file", "Não usar o arquivo", "Não usar o ficheiro"),
    MOVE_OUT(
            "Move to the nearest free place",
            "Mover para o lugar livre mais próximo",
            "Mover para o lugar livre mais próximo"),
    TAKE_NO_PORTALS("Make it not portalable", "Não aceitar portais aqui", "Não aceitar portais aqui"),
    ONE_MATERIAL("Give both faces %s", "Dar %s às duas faces", "Dar %s às duas faces"),
    ADD_START(
            "Add a start on the largest floor",
            "Adicionar um início no maior piso",
            "Adicionar um início no maior chão"),
    ADD_EXIT(
            "Add an exit far from the start",
            "Adicionar uma saída longe do início",
            "Adicionar uma saída longe do início");

    private final Words words;

    ProblemText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
