/** {@code sunbeam color}: colors by viewing angle. */
package sunbeam.app.commands.color;
