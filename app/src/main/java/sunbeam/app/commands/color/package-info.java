/** {@code sunbeam color}: colours by viewing angle. */
package sunbeam.app.commands.color;
