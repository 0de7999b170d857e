/** The command line: one class for each command, loaded only when the command is named. */
package nephele.app.command;
