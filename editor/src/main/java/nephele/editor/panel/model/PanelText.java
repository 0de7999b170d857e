package nephele.editor.panel.model;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the panels in English, Brazilian and European Portuguese. */
public enum PanelText implements Text {
    OUTLINER("Outliner", "Estrutura", "Estrutura"),
    SEARCH("Search: type:light size>4", "Buscar: type:light size>4", "Procurar: type:light size>4"),
    GROUPS("groups", "grupos", "grupos"),
    SHOWN("shown", "visível", "visível"),
    HIDDEN("hidden", "oculto", "oculto"),
    UNLOCKED("not locked", "não bloqueado", "não bloqueado"),
    LOCKED("locked", "bloqueado", "bloqueado"),
    NAME("name", "nome", "nome"),
    VISIBILITY("visibility", "visibilidade", "visibilidade"),
    LOCK("lock", "bloqueio", "bloqueio"),
    SHOW_OR_HIDE("Show or hide %s", "Mostrar ou ocultar %s", "Mostrar ou ocultar %s"),
    LOCK_OR_UNLOCK("Lock or unlock %s", "Bloquear ou desbloquear %s", "Bloquear ou desbloquear %s"),
    RENAME("Rename", "Renomear", "Mudar o nome"),
    RENAME_TO("Rename to %s", "Renomear para %s", "Mudar o nome para %s"),
    DELETE("Delete", "Excluir", "Eliminar"),
    FIND_USAGES("Find usages", "Encontrar usos", "Encontrar utilizações"),
    NO_USAGES("Nothing uses %s", "Nada usa %s", "Nada utiliza %s"),
    USAGES("%s entities use %s", "%s entidades usam %s", "%s entidades utilizam %s"),
    FOCUS("Look at it", "Olhar para ele", "Olhar para ele"),
    QUERY_NO_VALUE("%s: write a value after it", "%s: escreva um valor em seguida", "%s: escreve um valor a seguir"),
    QUERY_NO_NUMBER(
            "%s compares with a number, not with \"%s\"",
            "%s compara com um número, não com \"%s\"", "%s compara com um número, não com \"%s\""),
    QUERY_NO_TRUTH("%s: write true or false", "%s: escreva true ou false", "%s: escreve true ou false"),
    QUERY_NO_COMPONENT(
            "no entity has a component \"%s\"",
            "nenhuma entidade tem um campo \"%s\"", "nenhuma entidade tem um campo \"%s\""),
    INSPECTOR("Inspector", "Inspetor", "Inspetor"),
    THE_LEVEL("Level", "Fase", "Nível"),
    MANY_SELECTED("%s selected", "%s selecionados", "%s selecionados"),
    MIXED("mixed", "vários", "vários"),
    NOT_SET("not set", "não definido", "não definido"),
    SET_FIELD("Set %s", "Definir %s", "Definir %s"),
    UNSET_FIELD("Unset %s", "Não definir %s", "Não definir %s"),
    RESET_FIELD("Reset %s", "Restaurar %s", "Repor %s"),
    ADD_TO("Add to %s", "Adicionar a %s", "Adicionar a %s"),
    MOVE_UP_IN("Move up in %s", "Mover para cima em %s", "Mover para cima em %s"),
    MOVE_DOWN_IN("Move down in %s", "Mover para baixo em %s", "Mover para baixo em %s"),
    INSERT_INTO("Insert above into %s", "Inserir acima em %s", "Inserir acima em %s"),
    REMOVE_FROM("Remove from %s", "Remover de %s", "Remover de %s"),
    KEY_TO_ADD("Name of the new entry", "Nome da nova entrada", "Nome da nova entrada"),
    ENTRIES("%s entries", "%s entradas", "%s entradas"),
    MENU_OF("Menu of %s", "Menu de %s", "Menu de %s"),
    CHOOSE_FILE("Choose a file for %s", "Escolher um arquivo para %s", "Escolher um ficheiro para %s"),
    CHOOSE_COLOUR("Choose %s", "Escolher %s", "Escolher %s"),
    ID_TAKEN("the name %s is in use", "o nome %s já está em uso", "o nome %s já está em uso"),
    NO_NUMBER(
            "\"%s\" is no number; write one, or a sum such as 128/3",
            "\"%s\" não é um número; escreva um, ou uma conta como 128/3",
            "\"%s\" não é um número; escreve um, ou uma conta como 128/3"),
    COMPARE_TECHNIQUES("Compare techniques", "Comparar técnicas", "Comparar técnicas"),
    LEFT_TECHNIQUE("Technique on the left", "Técnica à esquerda", "Técnica à esquerda"),
    RIGHT_TECHNIQUE("Technique on the right", "Técnica à direita", "Técnica à direita"),
    WIPE("Wipe: drag it, or ← and →", "Divisória: arraste, ou ← e →", "Divisória: arrasta, ou ← e →"),
    DRAWING("Drawing …", "Desenhando …", "A desenhar …"),
    DIFFERS(
            "%s against %s:\nFLIP %s, mean light %s %%",
            "%s contra %s:\nFLIP %s, luz média %s %%", "%s contra %s:\nFLIP %s, luz média %s %%"),
    NO_DIFFERENCE("The two pictures do not differ", "As duas imagens não diferem", "As duas imagens não diferem"),
    HISTORY("History", "Histórico", "Histórico"),
    START("Start", "Início", "Início"),
    PALETTE("Palette", "Paleta", "Paleta"),
    SHAPES("Brushes", "Blocos", "Blocos"),
    MATERIALS("Materials", "Materiais", "Materiais"),
    GREY("grey", "cinza", "cinzento"),
    BOX("Box", "Caixa", "Caixa"),
    WEDGE("Wedge", "Cunha", "Cunha"),
    STAIRS("Stairs", "Escada", "Escada"),
    ARCH("Arch", "Arco", "Arco"),
    CYLINDER("Cylinder", "Cilindro", "Cilindro"),
    ROOM("Room", "Sala", "Sala"),
    PROBLEMS("Problems", "Problemas", "Problemas"),
    NO_PROBLEMS("No problems", "Nenhum problema", "Nenhum problema"),
    SEARCHING("Searching", "Procurando", "A procurar"),
    FIX("Fix", "Corrigir", "Corrigir"),
    HIDE("Hide", "Ocultar", "Ocultar"),
    HIDE_PROBLEM("Hide a problem", "Ocultar um problema", "Ocultar um problema"),
    ERROR("Error", "Erro", "Erro"),
    WARNING("Warning", "Aviso", "Aviso"),
    HINT("Hint", "Dica", "Sugestão");

    private final Words words;

    PanelText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
